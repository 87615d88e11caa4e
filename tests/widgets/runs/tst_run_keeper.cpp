// What becomes of an experiment that has ended: under which motor it is kept, with which registers, and whatever
// happens before they are read.
#include "session/files/run_book.h"
#include "session/files/snapshot_json.h"
#include "session/files/whole_file.h"
#include "support/window_facts.h"
#include "widgets/runs/keeper.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace {

constexpr std::uint32_t kGain = 0x100, kIntegral = 0x140;

/// The numbers of an experiment's wishes begin with the time at which it began.
constexpr TimePoint kEndsAt{std::chrono::seconds(20)};
drive::WishId wishOfRunFrom(TimePoint begin)
{
    return (drive::WishId{1} << 62) + drive::WishId(begin.time_since_epoch().count()) + 5;
}

drive::Identified twoMotors()
{
    drive::Identified board = facts::identified();
    board.identity.motors = 2;
    board.identity.motorNames = {"Left", "Right"};
    std::vector<catalog::RegisterInfo> registers;
    for (const auto &[id, name] :
        {std::pair(kGain, "SPEED_KP"), std::pair(kIntegral, "SPEED_KI")}) {
        registers.push_back(facts::makeRegister(id, name, "Speed loop"));
        registers.back().perMotor = true;
        registers.back().access = catalog::Access::ReadWrite;
        registers.back().effect = catalog::Effect::Kept;
    }
    board.catalog = std::make_shared<const catalog::Catalog>(
        std::move(registers), 2, std::vector<catalog::Scales>(2));
    board.limits = {board.limits.front(), board.limits.front()};
    return board;
}

widgets::Experiments::RunPtr anEnd(const char *motor)
{
    auto run = std::make_shared<widgets::Experiments::Run>();
    run->outcome.at = kEndsAt;
    const recorded::Happening plan{
        "step plan", {{"motor", motor}, {"from rpm", "1000"}, {"to rpm", "1500"}}};
    const recorded::Happening end{"experiment ended", {{"outcome", "complete"}, {"reason", ""}}};
    recorded::Nanos at = 1'000;
    for (const recorded::Happening &happening :
        {plan, recorded::Happening{"motor state", {{"state", "RUN"}}}, end}) {
        auto told = std::make_shared<session::Told>();
        told->at = at++;
        told->entries.emplace_back(happening);
        run->told.push_back(std::move(told));
        run->happenings.emplace_back(at, happening);
    }
    return run;
}

/// A board that answers when the test says so.
struct Board {
    QTemporaryDir folder;
    widgets::Device device;
    widgets::Experiments experiments{
        device, std::make_shared<session::RecordingTap>(), [] { return TimePoint{}; }};
    std::optional<widgets::RunKeeper> keeper;
    std::vector<drive::Wish> asked;
    std::map<drive::RegisterId, std::int64_t> held{
        {kGain + 1, 700}, {kIntegral + 1, 30}, {kGain + 2, 350}, {kIntegral + 2, 15}};

    Board()
    {
        QObject::connect(&device, &widgets::Device::wishMade, &experiments,
            [this](const drive::Wish &wish) { asked.push_back(wish); });
        facts::connectBoard(device);
        facts::feed(device, {twoMotors()});
        keeper.emplace(device, experiments, nullptr);
        keeper->setFolder(folder.path());
    }
    /// To the one read that is open.
    void answer()
    {
        QCOMPARE(asked.size(), 1U);
        const drive::Wish wish = asked.front();
        asked.clear();
        drive::RegistersRead read;
        for (const drive::RegisterId id : std::get<drive::Read>(wish.what).registers) {
            read.readings.push_back(facts::reading(id, held.at(id)));
            read.readings.back().at = TimePoint{} + std::chrono::seconds(1);
        }
        drive::Ended ended;
        ended.id = wish.id;
        facts::feed(device, {read, ended});
    }
    /// As by a notch of the wheel.
    void write(drive::RegisterId id, std::int64_t value, drive::WishId wish = 1'000)
    {
        drive::WriteResult result;
        result.id = id;
        result.before = catalog::Value(held.at(id));
        result.readBack = catalog::Value(value);
        held[id] = value;
        drive::Ended ended;
        ended.id = wish;
        ended.writes = {result};
        facts::feed(device, {ended});
    }
    std::optional<session::Run> kept(QSignalSpy &spy) const
    {
        const auto book = session::readRunBook(folder.path());
        if (!book || book->runs.empty() || (spy.isEmpty() && keeper))
            return std::nullopt;
        return book->runs.back();
    }
};

} // namespace

class TestRunKeeper : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aRunIsKeptUnderTheMotorThatItMeasured()
    {
        Board bench;
        QSignalSpy spy(&*bench.keeper, &widgets::RunKeeper::kept);
        bench.device.setMotor(1); // chosen while the other one was measured
        Q_EMIT bench.experiments.ended(anEnd("2"));
        bench.answer();
        QTRY_COMPARE(spy.size(), 1);
        const auto run = bench.kept(spy);
        QVERIFY(run);
        QCOMPARE(run->motor, 2);
        QCOMPARE(run->motorName, QStringLiteral("Right"));
        QCOMPARE(run->gains,
            (QMap<QString, double>{
                {QStringLiteral("SPEED_KI"), 15}, {QStringLiteral("SPEED_KP"), 350}}));
    }

    void whatIsWrittenBeforeItsRegistersAreReadIsNotOfTheRun()
    {
        Board bench;
        QSignalSpy spy(&*bench.keeper, &widgets::RunKeeper::kept);
        Q_EMIT bench.experiments.ended(anEnd("1"));
        bench.write(kGain + 1, 735);
        bench.write(kGain + 1, 772);
        bench.answer();
        QTRY_COMPARE(spy.size(), 1);
        const auto run = bench.kept(spy);
        QVERIFY(run && run->registers);
        QCOMPARE(run->gains[QStringLiteral("SPEED_KP")], 700.0);
        QCOMPARE(run->gains[QStringLiteral("SPEED_KI")], 30.0);
        const auto file = session::readWholeFile(session::registersOf(bench.folder.path(), 1));
        QVERIFY(file);
        const auto snapshot = session::readSnapshotJson(*file);
        QVERIFY(snapshot);
        const snapshots::Entry *gain = snapshot->find("SPEED_KP", 1);
        QVERIFY(gain != nullptr);
        QCOMPARE(std::get<std::int64_t>(gain->value), std::int64_t(700));

        // What came before the end is the run's.
        Q_EMIT bench.experiments.ended(anEnd("1"));
        bench.answer();
        QTRY_COMPARE(spy.size(), 2);
        QCOMPARE(bench.kept(spy)->gains[QStringLiteral("SPEED_KP")], 772.0);
    }

    void whatTheExperimentGaveBackMayBeToldLate()
    {
        Board bench;
        QSignalSpy spy(&*bench.keeper, &widgets::RunKeeper::kept);
        bench.held[kGain + 1] = 90; // lent
        Q_EMIT bench.experiments.ended(anEnd("1"));
        bench.write(kGain + 1, 700, wishOfRunFrom(kEndsAt - std::chrono::seconds(5)));
        bench.answer();
        QTRY_COMPARE(spy.size(), 1);
        QCOMPARE(bench.kept(spy)->gains[QStringLiteral("SPEED_KP")], 700.0);
    }

    void aRunThatBeginsAtOnceLeavesTheLastOneItsRegisters()
    {
        Board bench;
        QSignalSpy spy(&*bench.keeper, &widgets::RunKeeper::kept);
        Q_EMIT bench.experiments.ended(anEnd("1"));
        Q_EMIT bench.experiments.began();
        bench.write(kGain + 1, 90, wishOfRunFrom(kEndsAt)); // lent
        bench.answer();
        QTRY_COMPARE(spy.size(), 1);
        const auto run = bench.kept(spy);
        QVERIFY(run && run->registers);
        QCOMPARE(run->gains[QStringLiteral("SPEED_KP")], 700.0);
        QCOMPARE(run->gains[QStringLiteral("SPEED_KI")], 30.0);
    }

    void aWindowThatIsClosedMeanwhileKeepsTheRunWithoutRegisters()
    {
        Board bench;
        QSignalSpy spy(&*bench.keeper, &widgets::RunKeeper::kept);
        Q_EMIT bench.experiments.ended(anEnd("2"));
        bench.keeper.reset();
        const auto run = bench.kept(spy);
        QVERIFY(run);
        QCOMPARE(run->motor, 2);
        QVERIFY(!run->registers && run->gains.isEmpty());
    }
};

QTEST_MAIN(TestRunKeeper)
#include "tst_run_keeper.moc"
