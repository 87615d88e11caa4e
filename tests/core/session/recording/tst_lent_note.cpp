// What an experiment has borrowed when its program is killed is said when its board is met again, until it was written.
#include "core/session/link/lab_world.h"
#include "drive/values.h"
#include "lab/runner.h"
#include "session/recording/lent_note.h"
#include "support/lab_bench.h"
#include "support/mcb/pair.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

using namespace std::chrono_literals;
using session::LentNote;

namespace {

constexpr const char *kStages = "REVUP_DATA";
constexpr const char *kGain = "SPEED_KP";

struct LentServo : support::McbPair {
    LentServo()
        : ready(meet())
    {
        drive->arm();
        exchange();
    }
    bool ready;
};

/// A board without a sensor, and a program that keeps notes in a folder.
struct World : support::LabWorld {
    std::shared_ptr<LentNote> note;
    QSignalSpy left;
    QString path; ///< where it is kept

    explicit World(const QString &folder)
        : World(std::make_shared<LentNote>(folder))
    {
        path = folder;
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

    static constexpr drive::WishId kWish = lab::Runner::kFirstWish;
    /// The note alone hears that an experiment writes the gain.
    void wishes(int number, const catalog::Value &value) const
    {
        note->onWish({.id = kWish + drive::WishId(number),
                         .what = drive::Write{{{id(kGain), value}}, drive::Reach::Parameters}},
            now);
    }
    int notes() const { return int(QDir(path).entryList(QDir::Files).size()); }
    /// What was told last: a text, and what brings it back.
    QString text() const { return left.last().at(0).toString(); }
    std::vector<drive::RegisterWrite> back() const
    {
        return left.last().at(1).value<std::vector<drive::RegisterWrite>>();
    }
    bool tellsBack(const char *name, const catalog::Value &value) const
    {
        const auto all = back();
        return all.size() == 1 && all.front().id == id(name) && all.front().value == value;
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
            QVERIFY(next.tellsBack(kStages, before));
            if (again == 1) {
                QVERIFY(next.writes(kStages, before));
                QCOMPARE(next.left.size(), 2);
                QVERIFY(next.text().isEmpty() && next.back().empty());
            }
        }
        World later(folder.path());
        QVERIFY(later.connect());
        QVERIFY(later.left.isEmpty());
    }

    /// How a servo drive goes to its speeds is told with each of them, and is given back at the end.
    void howADriveWentToItsSpeedIsBorrowedToo()
    {
        const QTemporaryDir folder;
        session::Endpoint endpoint;
        endpoint.kind = session::Endpoint::Kind::Serial;
        const auto metAgain = [&](const drive::Identified &board) {
            LentNote next(folder.path());
            const QSignalSpy left(&next, &LentNote::left);
            next.begin(endpoint);
            next.onEvent(board, {});
            return left.isEmpty() ? QString() : left.last().first().toString();
        };
        support::LabBenchOn<LentServo> bench;
        QVERIFY(bench.pair.ready);
        const drive::Identified board = *bench.pair.identified;
        LentNote note(folder.path());
        note.begin(endpoint);
        note.onEvent(board, {});
        bench.pair.onEvent = [&, before = bench.pair.onEvent](const drive::Event &event) {
            note.onEvent(event, {});
            before(event);
        };
        std::size_t told = 0;
        bench.eachTurn = [&] {
            while (told < bench.wishes.size())
                note.onWish(bench.wishes[told++], {});
        };
        bench.begin();
        const auto moves = [&] { return bench.asked<drive::SpeedRamp>().size() >= 2; };
        QVERIFY(bench.runUntil(moves, 20s));
        const QString killed = metAgain(board); // as it stands now
        for (const std::string_view name : board.catalog->start().way)
            QVERIFY2(killed.contains(
                         QString::fromStdString(std::string(name)) + QStringLiteral(" may hold")),
                qPrintable(killed));
        QVERIFY(bench.runUntil([&] { return bench.runner->over(); }, 60s));
        VERIFY_END(bench.runner->outcome(), lab::End::Complete);
        QCOMPARE(metAgain(board), QString());
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
            QVERIFY(world.left.isEmpty());
            world.note->tell(); // the experiment is over
            QCOMPARE(world.left.size(), 1);
            QVERIFY(world.text().startsWith(QLatin1String(kStages)));
            QVERIFY(world.idles());
        }
        World next(folder.path());
        QVERIFY(next.connect());
        QCOMPARE(next.left.size(), 1);
    }

    void whatWasNotWrittenIsNotBorrowed_data()
    {
        using drive::Outcome;
        QTest::addColumn<int>("whole");
        QTest::addColumn<int>("ofRegister"); // -1: it is not told by register
        QTest::addColumn<bool>("readsOther");
        QTest::addColumn<bool>("borrowed");
        const auto row = [](const char *name, Outcome whole, int ofRegister, bool other,
                             bool kept) {
            QTest::newRow(name) << int(whole) << ofRegister << other << kept;
        };
        row("not sent", Outcome::NotSent, -1, false, false);
        row("refused", Outcome::Refused, -1, false, false);
        row("unknown", Outcome::Unknown, -1, false, true);
        row("this one not sent", Outcome::Unknown, int(Outcome::NotSent), false, false);
        row("this one refused", Outcome::Unknown, int(Outcome::Refused), false, false);
        row("this one unknown", Outcome::Refused, int(Outcome::Unknown), false, true);
        row("this one written", Outcome::Refused, int(Outcome::Ok), true, true);
        row("refused, yet changed", Outcome::Refused, int(Outcome::Refused), true, true);
    }

    /// Nor is it when what it holds is written once more, as the end of an experiment does.
    void whatWasNotWrittenIsNotBorrowed()
    {
        QFETCH(const int, whole);
        QFETCH(const int, ofRegister);
        QFETCH(const bool, readsOther);
        QFETCH(const bool, borrowed);
        const QTemporaryDir folder;
        World world(folder.path());
        QVERIFY(world.connect());
        const catalog::Value before = world.held(kGain), other = std::int64_t{1};
        QVERIFY(before != other);
        const drive::RegisterId id = world.id(kGain);
        world.wishes(1, other);
        QCOMPARE(world.notes(), 1);
        drive::Ended ended{World::kWish + 1, static_cast<drive::Outcome>(whole), {}, {}};
        if (ofRegister >= 0)
            ended.writes = {{.id = id,
                .outcome = static_cast<drive::Outcome>(ofRegister),
                .reason = {},
                .before = before,
                .readBack = readsOther ? other : before,
                .verified = {}}};
        world.note->onEvent(ended, world.now);
        QCOMPARE(world.notes(), borrowed ? 1 : 0);
        world.wishes(2, before);
        QCOMPARE(world.notes(), borrowed ? 1 : 0);
    }

    /// A second try that is not sent says nothing of the first, whose answer was lost.
    void whatMayHaveBeenWrittenStaysBorrowed()
    {
        const QTemporaryDir folder;
        World world(folder.path());
        QVERIFY(world.connect());
        QVERIFY(world.held(kGain) != catalog::Value{std::int64_t{1}});
        for (const auto &[wish, outcome] :
            {std::pair(1, drive::Outcome::Unknown), std::pair(2, drive::Outcome::NotSent)}) {
            world.wishes(wish, std::int64_t{1});
            world.note->onEvent(
                drive::Ended{World::kWish + drive::WishId(wish), outcome, {}, {}}, world.now);
            QCOMPARE(world.notes(), 1);
        }
    }

    /// A board may take a value and make another one of it.
    void whatIsReadBackOtherwiseStaysBorrowed()
    {
        const QTemporaryDir folder;
        World world(folder.path());
        QVERIFY(world.connect());
        const catalog::Value before = world.held(kGain);
        world.wishes(1, std::int64_t{1});
        world.note->tell();
        QVERIFY(world.tellsBack(kGain, before));
        drive::Ended ended{7, drive::Outcome::Ok, {}, {}};
        ended.writes = {{.id = world.id(kGain),
            .outcome = drive::Outcome::Ok,
            .reason = {},
            .before = {},
            .readBack = std::int64_t{2},
            .verified = false}};
        world.note->onEvent(ended, world.now);
        QCOMPARE(world.notes(), 1);
        ended.writes.front().verified = {}; // nor is one that nobody has read back
        world.note->onEvent(ended, world.now);
        QCOMPARE(world.notes(), 1);
        QCOMPARE(world.left.size(), 1);
        ended.writes.front().verified = true;
        world.note->onEvent(ended, world.now);
        QCOMPARE(world.notes(), 0);
        QVERIFY(world.text().isEmpty());
    }

    /// Another connection may be one to another board.
    void whatIsLeftIsOfOneConnection()
    {
        const QTemporaryDir folder;
        World world(folder.path());
        QVERIFY(world.connect());
        QVERIFY(world.held(kGain) != catalog::Value{std::int64_t{1}});
        world.wishes(1, std::int64_t{1});
        world.note->tell();
        world.note->begin(world.endpoint);
        QCOMPARE(world.left.size(), 2);
        QVERIFY(world.text().isEmpty());
        QCOMPARE(world.notes(), 1);
    }

    /// A drive tells its board again when less of it turns out to work: an experiment goes on, and has left nothing.
    void aBoardThatIsToldAgainIsNotMetAgain()
    {
        const QTemporaryDir folder;
        World world(folder.path());
        QVERIFY(world.connect());
        QVERIFY(world.held(kGain) != catalog::Value{std::int64_t{1}});
        world.wishes(1, std::int64_t{1});
        world.note->onEvent(*world.board(), world.now);
        QVERIFY(world.left.isEmpty());
        QCOMPARE(world.notes(), 1);
    }

    /// A number alone names no register: the file may be older than the table, or another board's.
    void whatHasAnotherNameIsNotOffered()
    {
        const QTemporaryDir folder;
        {
            World killed(folder.path());
            QVERIFY(killed.connect());
            QVERIFY(killed.borrows());
        }
        const QStringList files = QDir(folder.path()).entryList(QDir::Files);
        QCOMPARE(files.size(), 1);
        QFile file(QDir(folder.path()).filePath(files.first()));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray content = file.readAll();
        file.close();
        QVERIFY(content.contains(kStages));
        content.replace(kStages, "OTHER_DATA");
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
        file.close();
        World next(folder.path());
        QVERIFY(next.connect());
        QCOMPARE(next.left.size(), 1);
        QVERIFY(next.text().startsWith(QStringLiteral("OTHER_DATA may hold")));
        QVERIFY(next.back().empty());
    }

    /// What is given back is what was there, to its last digit.
    void aValueComesBackExactly()
    {
        using catalog::ValueType;
        const catalog::Value large(std::int64_t{12345678}), fine(double{0.012345679F});
        QVERIFY(lab::typedValue(lab::typedText(large), ValueType::S32) == large);
        QVERIFY(drive::sameValue(fine, *lab::typedValue(lab::typedText(fine), ValueType::F32)));
    }

    void whatMakesNoValueIsNotOffered()
    {
        using catalog::ValueType;
        using lab::typedValue;
        QVERIFY(typedValue("\"2C 01\"", ValueType::Raw) == catalog::Value(Bytes{0x2C, 0x01}));
        QVERIFY(typedValue("-12", ValueType::S16) == catalog::Value(std::int64_t{-12}));
        QVERIFY(typedValue("0.5", ValueType::F32) == catalog::Value(0.5));
        for (const char *text : {"", "\"", "2C 01", "\"2C 0\""})
            QVERIFY(!typedValue(text, ValueType::Raw));
        for (const char *text : {"", "x", "1e300", "40000", "nan", "\"01\""})
            QVERIFY(!typedValue(text, ValueType::S16));
        QVERIFY(!typedValue("inf", ValueType::F32));
    }

    /// It is gone when its program is: until then it is told, from memory.
    void aBoardWithinTheProgramHasNone()
    {
        const QTemporaryDir folder;
        World world(folder.path());
        world.endpoint.kind = session::Endpoint::Kind::Simulator;
        QVERIFY(world.connect());
        const catalog::Value before = world.held(kStages);
        QVERIFY(world.borrows());
        QVERIFY(QDir(folder.path()).entryList(QDir::Files).isEmpty());
        world.session.stop();
        QVERIFY(world.ends());
        world.note->tell();
        QVERIFY(QDir(folder.path()).entryList(QDir::Files).isEmpty());
        QCOMPARE(world.left.size(), 1);
        QVERIFY(world.tellsBack(kStages, before));
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
