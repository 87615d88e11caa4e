// Lists of writes that come from forms and files: one step each, judged as a whole, told register by register.
#include "support/edit_bench.h"

#include <QTest>

using catalog::Value;
using facts::EditBench;
using widgets::RegisterModel;
using State = RegisterModel::EditState;
using namespace std::chrono_literals;

namespace {

std::int64_t number(EditBench &bench, const char *name)
{
    return std::get<std::int64_t>(bench.held(name));
}

drive::RegisterWrite to(const EditBench &bench, const char *name, std::int64_t value)
{
    return {bench.id(name), value};
}

/// The newest report of the edits.
struct Reports {
    explicit Reports(EditBench &bench)
    {
        QObject::connect(&bench.edits, &widgets::RegisterEdits::reported, &bench.panel,
            [this](const widgets::WriteReport &report) { all.append(report); });
    }
    QList<widgets::WriteReport> all;
};

} // namespace

class TestRegisterWrites : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void aListIsOneStepWithAName()
    {
        EditBench bench;
        Reports reports(bench);
        bench.arm();
        const auto kp = number(bench, "SPEED_KP"), ki = number(bench, "SPEED_KI");
        bench.edits.write(
            QStringLiteral("Gains"), {to(bench, "SPEED_KP", 77), to(bench, "SPEED_KI", 78)});
        QVERIFY(bench.settle());
        QCOMPARE(bench.edits.steps().count(), 1);
        QCOMPARE(bench.edits.steps().undoText(), QStringLiteral("Gains"));
        QCOMPARE(number(bench, "SPEED_KP"), 77);
        QCOMPARE(reports.all.size(), 1);
        QVERIFY(reports.all.first().good());
        QCOMPARE(reports.all.first().written,
            (QStringList{QStringLiteral("SPEED_KP"), QStringLiteral("SPEED_KI")}));
        bench.edits.undo();
        QVERIFY(bench.settle());
        QCOMPARE(number(bench, "SPEED_KP"), kp);
        QCOMPARE(number(bench, "SPEED_KI"), ki);
        bench.type("SPEED_KD", QStringLiteral("5")); // the name does not stick
        QVERIFY(bench.apply());
        QCOMPARE(bench.edits.steps().undoText(), QStringLiteral("SPEED_KD"));
    }

    void nothingIsWrittenUnlessArmed()
    {
        EditBench bench;
        bench.edits.write(QStringLiteral("Gains"), {to(bench, "SPEED_KP", 77)});
        QVERIFY(!bench.edits.underWay());
        QVERIFY(bench.writes.empty());
    }

    void anEditThatWaitsOutlivesWritesThatAreNotItsOwn()
    {
        EditBench bench;
        bench.arm();
        bench.type("SPEED_KP", QStringLiteral("55"));
        bench.type("SPEED_KI", QStringLiteral("78"));
        bench.type("I_Q_KP", QStringLiteral("9"));
        bench.edits.write({}, {to(bench, "SPEED_KP", 77), to(bench, "SPEED_KI", 78)});
        QVERIFY(bench.settle());
        QVERIFY(bench.model.editState(bench.id("SPEED_KP")) == State::Pending); // wants 55 still
        // Has what it wanted.
        QVERIFY(bench.model.editState(bench.id("SPEED_KI")) == State::Verified);
        QVERIFY(bench.model.editState(bench.id("I_Q_KP")) == State::Pending);
        QCOMPARE(number(bench, "SPEED_KP"), 77);
        bench.edits.undo();
        QVERIFY(bench.settle());
        QVERIFY(bench.model.editState(bench.id("SPEED_KP")) == State::Pending);
        QVERIFY(bench.apply());
        QCOMPARE(number(bench, "SPEED_KP"), 55);
        QCOMPARE(number(bench, "I_Q_KP"), 9);
    }

    void bothHalvesOfAGainAreJudgedTogether()
    {
        EditBench bench;
        bench.arm();
        QVERIFY(bench.type("SPEED_KP", QStringLiteral("1000")));
        QVERIFY(bench.type("SPEED_KP_DIV", QStringLiteral("8")));
        QVERIFY(bench.apply());
        facts::feed(bench.device, {facts::status(drive::MotorState::Running)});
        bench.type("SPEED_KP", QStringLiteral("4000"));
        bench.type("SPEED_KP_DIV", QStringLiteral("10"));
        QVERIFY(bench.apply());
        QCOMPARE(bench.questions, 0);
        QCOMPARE(number(bench, "SPEED_KP"), 4000);
        QCOMPARE(bench.writes.back().writes.front().id, bench.id("SPEED_KP_DIV")); // lower first
        facts::feed(bench.device, {facts::status(drive::MotorState::Running)});
        bench.edits.undo();
        QVERIFY(bench.settle());
        QCOMPARE(bench.questions, 0);
        QCOMPARE(bench.writes.back().writes.front().id, bench.id("SPEED_KP"));
        QCOMPARE(number(bench, "SPEED_KP"), 1000);
        QCOMPARE(number(bench, "SPEED_KP_DIV"), 8);
        facts::feed(bench.device, {facts::status(drive::MotorState::Running)});
        bench.type("SPEED_KP", QStringLiteral("4000")); // without the other half
        bench.edits.apply();
        QCoreApplication::processEvents();
        QCOMPARE(bench.questions, 1);
        QVERIFY(number(bench, "SPEED_KP") == 1000);
    }

    void anUnplugLeavesNoRegisterUntold()
    {
        simulation::BoardOptions options;
        options.rxMax = 32; // seven to a request
        EditBench bench(options);
        Reports reports(bench);
        bench.arm();
        std::vector<drive::RegisterWrite> writes;
        QStringList names;
        for (const char *name : {"SPEED_KP", "SPEED_KI", "SPEED_KD", "I_Q_KP", "I_Q_KI", "I_Q_KD",
                 "I_D_KP", "I_D_KI", "I_D_KD", "STOPLL_C1", "STOPLL_C2", "STOPLL_KP", "STOPLL_KI",
                 "SPEED_KP_DIV", "SPEED_KI_DIV", "SPEED_KD_DIV"}) {
            writes.push_back(to(bench, name, 7));
            names.append(QString::fromLatin1(name));
        }
        int sets = 0;
        bench.link.loses = [&](const Bytes &bytes) {
            if (bench.edits.underWay() && support::changesSomething(bytes) && bytes.size() > 8)
                ++sets;
            if (sets >= 2)
                bench.link.toBoard.cut = bench.link.toDrive.cut = true;
            return false;
        };
        bench.edits.write(QStringLiteral("Restore"), writes);
        QVERIFY(bench.link.runUntil([&] { return !bench.edits.underWay(); }, 30s));
        QCOMPARE(reports.all.size(), 1);
        const widgets::WriteReport report = reports.all.first();
        QCOMPARE(report.unproved.size(), 7); // nothing could be read back
        QCOMPARE(report.unproved.size() + report.unknown.size() + report.notWritten.size(), 16);
        QVERIFY(!report.unknown.isEmpty()); // the second request may have arrived
        QVERIFY(!report.notWritten.isEmpty()); // the third never left
        QStringList told = report.unproved + report.unknown + report.different;
        for (const QString &line : report.notWritten)
            told.append(line.section(QLatin1Char(':'), 0, 0));
        told.sort();
        names.sort();
        QCOMPARE(told, names);
        // What the board really holds agrees with that.
        bench.link.loses = nullptr;
        bench.link.toBoard.cut = bench.link.toDrive.cut = false;
        QVERIFY(bench.link.runUntil(
            [&] { return bench.device.link().state == drive::LinkState::Connected; }, 30s));
        for (const QString &name : report.unproved)
            QCOMPARE(number(bench, name.toLatin1()), 7);
        for (const QString &line : report.notWritten)
            QVERIFY(number(bench, line.section(QLatin1Char(':'), 0, 0).toLatin1()) != 7);
    }

    void whatNeverReachedTheDriveIsToldAsNotWritten()
    {
        EditBench bench;
        Reports reports(bench);
        bench.arm();
        bench.device.blockSignals(true); // the session's answer is made up
        bench.edits.write({}, {to(bench, "SPEED_KP", 77), to(bench, "SPEED_KI", 78)});
        bench.device.blockSignals(false);
        const drive::WishId wish = bench.device.submit(drive::Watch{}) - 1;
        facts::feed(
            bench.device, {drive::Ended{wish, drive::Outcome::NotSent, "disconnected", {}}});
        QCOMPARE(reports.all.size(), 1);
        QCOMPARE(reports.all.first().notWritten.size(), 2);
        QVERIFY(reports.all.first().notWritten.first().contains(QStringLiteral("SPEED_KP")));
        QVERIFY(!bench.edits.underWay());
    }
};

QTEST_MAIN(TestRegisterWrites)
#include "tst_register_writes.moc"
