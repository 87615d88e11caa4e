// What an experiment has borrowed when its program is killed is said when its board is met again, until it was written.
#include "core/session/link/lab_world.h"
#include "session/recording/lent_note.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

using namespace std::chrono_literals;
using session::LentNote;

namespace {

constexpr const char *kStages = "REVUP_DATA";

/// A board without a sensor, and a program that keeps notes in a folder.
struct World : support::LabWorld {
    std::shared_ptr<LentNote> note;
    QSignalSpy left;

    explicit World(const QString &folder)
        : World(std::make_shared<LentNote>(folder))
    {
    }

    /// The resistance is measured, as far as the start-up that turns nothing.
    bool borrows()
    {
        const lab::Subject subject = *lab::subjectOf(*board(), 1);
        session.run({lab::restPlanFor(subject, {}), subject});
        return runUntil([this] { return status->state == drive::MotorState::Starting; }, 20s);
    }
    catalog::Value held(const char *name)
    {
        session.submit({.id = 71, .what = drive::Read{{id(name)}}});
        catalog::Value value;
        (void)runUntil(
            [&] {
                for (const auto &read : all<drive::RegistersRead>())
                    for (const drive::Reading &one : read.readings)
                        if (one.id == id(name))
                            value = one.value;
                return ended(71);
            },
            5s);
        return value;
    }
    bool writes(const char *name, const catalog::Value &value)
    {
        session.submit(
            {.id = 72, .what = drive::Write{{{id(name), value}}, drive::Reach::Parameters}});
        return runUntil([this] { return ended(72); }, 5s);
    }

private:
    explicit World(std::shared_ptr<LentNote> kept)
        : LabWorld(withoutSensor(), kept)
        , note(std::move(kept))
        , left(note.get(), &LentNote::left)
    {
        endpoint.kind = session::Endpoint::Kind::Serial;
        endpoint.path = QStringLiteral("/dev/ttyMotor");
    }
    static simulation::BoardOptions withoutSensor()
    {
        simulation::BoardOptions options;
        options.motor = "pm24";
        return options;
    }
    bool ended(drive::WishId wish) const
    {
        const auto ends = all<drive::Ended>();
        return std::ranges::any_of(
            ends, [wish](const drive::Ended &one) { return one.id == wish; });
    }
};

} // namespace

class TestLentNote : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatAKilledProgramLeftIsSaidUntilItIsWritten()
    {
        const QTemporaryDir folder;
        QString set;
        catalog::Value before;
        {
            World killed(folder.path());
            QVERIFY(killed.connect());
            before = killed.held(kStages);
            set = QStringLiteral("rotorscope-cli set REVUP_DATA=")
                + QString::fromStdString(lab::typedText(before));
            QVERIFY(killed.borrows());
            QVERIFY(killed.left.isEmpty());
        } // nothing is given back any more
        for (int again = 0; again < 2; ++again) {
            World next(folder.path());
            QVERIFY(next.connect());
            QCOMPARE(next.left.size(), 1);
            const QString said = next.left.first().first().toString();
            QVERIFY2(said.startsWith(QStringLiteral(
                         "REVUP_DATA may hold what the experiment wrote; what it held before "))
                    && said.endsWith(set),
                qPrintable(said));
            if (again == 1)
                QVERIFY(next.writes(kStages, before));
        }
        World later(folder.path());
        QVERIFY(later.connect());
        QVERIFY(later.left.isEmpty());
    }

    void whatIsGivenBackLeavesNoNote()
    {
        const QTemporaryDir folder;
        World world(folder.path());
        QVERIFY(world.connect());
        QVERIFY(world.borrows());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
        QVERIFY(world.ends());
        QCOMPARE(int(world.outcomes[0].end), int(lab::End::Complete));
        QVERIFY(QDir(folder.path()).entryList(QDir::Files).isEmpty());
    }

    /// A Stop writes nothing back: its sentence says what is left, and so does the next connection.
    void whatAStopLeftIsSaidAgain()
    {
        const QTemporaryDir folder;
        {
            World world(folder.path());
            QVERIFY(world.connect());
            QVERIFY(world.borrows());
            world.session.stop();
            QVERIFY(world.ends());
            QVERIFY(world.outcomes[0].leaves);
            QVERIFY(world.idles());
        }
        World next(folder.path());
        QVERIFY(next.connect());
        QCOMPARE(next.left.size(), 1);
    }

    /// It is gone when its program is.
    void aBoardWithinTheProgramHasNone()
    {
        const QTemporaryDir folder;
        World world(folder.path());
        world.endpoint.kind = session::Endpoint::Kind::Simulator;
        QVERIFY(world.connect());
        QVERIFY(world.borrows());
        QVERIFY(QDir(folder.path()).entryList(QDir::Files).isEmpty());
    }

    void aNoteThatMakesNoSenseSaysNothing()
    {
        const QTemporaryDir folder;
        {
            World world(folder.path());
            QVERIFY(world.connect());
            QVERIFY(world.borrows());
        }
        const QStringList files = QDir(folder.path()).entryList(QDir::Files);
        QCOMPARE(files.size(), 1);
        QFile file(QDir(folder.path()).filePath(files.first()));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("[{}") == 3);
        file.close();
        World next(folder.path());
        QVERIFY(next.connect());
        QVERIFY(next.left.isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestLentNote)
#include "tst_lent_note.moc"
