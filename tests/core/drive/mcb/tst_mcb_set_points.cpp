// Set-points that travel with every exchange: they move nothing by being mapped, are confirmed by what is read back, go
// to rest with a stop and with a fault, and are never repeated to a drive that was reset or met again.
#include "support/mcb/pair.h"

#include <QtTest>

#include <bit>
#include <cmath>
#include <functional>

using namespace drive;
using namespace std::chrono_literals;
using support::McbPair;

namespace {

constexpr std::uint16_t kControl = 0x010, kMode = 0x014, kIq = 0x01A, kPosition = 0x020,
                        kVelocity = 0x021;
constexpr Duration kStall = 700ms;

void armServo(McbPair &pair)
{
    pair.drive->arm();
    pair.exchange();
}

bool startServo(McbPair &pair)
{
    return pair.ask(Command{}).outcome == Outcome::Ok && pair.runUntilState(MotorState::Running);
}

/// What the drive itself has.
double has(const McbPair &pair, std::uint16_t address)
{
    const auto *content = pair.board->slave().registers().find(address);
    return std::bit_cast<float>(
        static_cast<std::uint32_t>(mcb::numberOf(content->words, 4).value_or(0)));
}

bool wrote(const McbPair &pair, std::uint16_t address)
{
    return std::any_of(pair.writes.begin(), pair.writes.end(),
        [&](const mcb::Frame &frame) { return frame.address == address; });
}

/// Notes what the bench sends and tells.
struct SetPointBench {
    McbPair pair;
    std::vector<bool> told;
    std::vector<mcb::Frame> sent; ///< frames with cyclic words
    bool keep = false;

    explicit SetPointBench(simulation::McbBoardOptions options = {}, Duration stall = {})
        : pair(std::move(options), stall)
    {
        pair.onEvent = [this](const Event &event) {
            if (const auto *changed = std::get_if<CyclicSetPointsChanged>(&event))
                told.push_back(changed->on);
        };
        pair.toBoard = [this](Bytes &out) {
            const auto frame = mcb::decodeFrame(out);
            if (keep && frame && !frame->cyclic.empty())
                sent.push_back(*frame);
        };
    }
    bool travels()
    {
        if (!pair.meet())
            return false;
        armServo(pair);
        return pair.ask(CyclicSetPoints{}).outcome == Outcome::Ok
            && told == std::vector<bool>{true};
    }
    double velocitySent(const mcb::Frame &frame) const // the first of the mapping
    {
        return std::bit_cast<float>(
            static_cast<std::uint32_t>(frame.cyclic[0] | frame.cyclic[1] << 16));
    }
    bool turnAt(int rpm)
    {
        return startServo(pair) && pair.ask(SpeedRamp{1, rpm, 0ms}).outcome == Outcome::Ok
            && pair.runUntil(
                [&] { return pair.status->speedRpm && *pair.status->speedRpm > 0.8 * rpm; }, 5s);
    }
};

} // namespace

class TestMcbSetPoints : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theyBeginArmedOnly();
    void theyBeginWhileTheMotorStandsOnly();
    void mappingMovesNothing();
    void aSpeedGoesWithTheFramesAndIsReadBack();
    void currentsGoWithTheFrames();
    void aRegisterWrittenByHandGoesWithTheFrames();
    void aPositionIsNeverMapped();
    void theMotionLogHasTheFrame();
    void signalsAreStreamedBesideThem();
    void signalsChangeWhileTheMotorTurns();
    void switchedOffTheDriveKeepsItsSetPoint();
    void aStopPutsThemToRestWithItsFirstFrame();
    void aFaultPutsThemToRest();
    void disarmingHoldsThem();
    void whatNoFrameHadNoneHasAfterwards_data();
    void whatNoFrameHadNoneHasAfterwards();
    void aResetEndsThem();
    void aProgramThatWasKilledRepeatsNothing();
    void aLostLinkEndsThem();
    void damagedFramesChangeNothing();
    void anotherValueReadBackIsTold();
    void disconnectingLeavesTheConfigState();
};

void TestMcbSetPoints::theyBeginArmedOnly()
{
    SetPointBench bench;
    McbPair &pair = bench.pair;
    QVERIFY(pair.meet());
    const auto done = pair.ask(CyclicSetPoints{});
    QVERIFY(done.outcome == Outcome::NotSent);
    QVERIFY(pair.writes.empty());
    QVERIFY(bench.told.empty());
    const auto &can = pair.identified->capabilities;
    QVERIFY(std::any_of(can.begin(), can.end(),
        [](const Capability &c) { return c.feature == Feature::CyclicSetPoints && c.available; }));
}

void TestMcbSetPoints::theyBeginWhileTheMotorStandsOnly()
{
    SetPointBench bench;
    McbPair &pair = bench.pair;
    QVERIFY(pair.meet());
    armServo(pair);
    QVERIFY(bench.turnAt(600));
    const auto done = pair.ask(CyclicSetPoints{});
    QVERIFY(done.outcome == Outcome::Refused);
    QCOMPARE(done.reason, std::string("only while the motor stands"));
    QVERIFY(!pair.board->slave().cyclic());
    // Neither while it coasts.
    pair.stopped = true;
    pair.drive->stop(pair.now);
    QVERIFY(pair.runUntil([&] { return pair.status->state == MotorState::Idle; }, 2s));
    pair.drive->arm();
    if (pair.status->speedRpm && std::abs(*pair.status->speedRpm) > 50.0 && pair.drive->armed())
        QVERIFY(pair.ask(CyclicSetPoints{}).outcome == Outcome::Refused);
}

void TestMcbSetPoints::mappingMovesNothing()
{
    SetPointBench bench;
    McbPair &pair = bench.pair;
    QVERIFY(pair.meet());
    armServo(pair);
    QVERIFY(pair.ask(SpeedRamp{1, 300, 0ms}).outcome == Outcome::Ok); // for the next start
    QCOMPARE(has(pair, kVelocity), 5.0);
    bench.keep = true;
    QVERIFY(pair.ask(CyclicSetPoints{}).outcome == Outcome::Ok);
    pair.runFor(20ms);
    QVERIFY(pair.board->slave().cyclic());
    QVERIFY(bench.sent.size() > 10);
    for (const mcb::Frame &frame : bench.sent)
        QCOMPARE(bench.velocitySent(frame), 5.0);
    QCOMPARE(has(pair, kVelocity), 5.0);
}

void TestMcbSetPoints::aSpeedGoesWithTheFramesAndIsReadBack()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    QVERIFY(startServo(pair));
    pair.writes.clear();
    bench.keep = true;
    QVERIFY(pair.ask(SpeedRamp{1, 900, 0ms}).outcome == Outcome::Ok);
    QVERIFY(!wrote(pair, kVelocity));
    QCOMPARE(has(pair, kVelocity), 15.0);
    QVERIFY(std::any_of(bench.sent.begin(), bench.sent.end(), [](const mcb::Frame &frame) {
        return frame.command == mcb::Command::Read && frame.address == kVelocity;
    }));
    pair.runFor(2s);
    QVERIFY2(std::abs(*pair.status->speedRpm - 900.0) < 60.0,
        qPrintable(QString::number(*pair.status->speedRpm)));
    // A ramp takes its time.
    QVERIFY(pair.ask(SpeedRamp{1, 300, 400ms}).outcome == Outcome::Ok);
    pair.runFor(2s);
    QVERIFY(std::abs(*pair.status->speedRpm - 300.0) < 60.0);
}

void TestMcbSetPoints::currentsGoWithTheFrames()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    pair.writes.clear();
    QVERIFY(pair.ask(CurrentReference{1, 0.25, 0.0}).outcome == Outcome::Ok);
    QVERIFY(!wrote(pair, kIq));
    QVERIFY(wrote(pair, kMode));
    QCOMPARE(has(pair, kIq), 0.25);
    // One beyond the limit is refused as ever.
    QVERIFY(pair.ask(CurrentReference{1, 1000.0, 0.0}).outcome == Outcome::Refused);
    QCOMPARE(has(pair, kIq), 0.25);
}

void TestMcbSetPoints::aRegisterWrittenByHandGoesWithTheFrames()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    pair.writes.clear();
    const auto done = pair.ask(Write{{{pair.id("CL_VEL_SET_POINT_VALUE"), 2.5}}});
    QVERIFY(done.outcome == Outcome::Ok);
    QVERIFY(done.writes.front().verified.value_or(false));
    QVERIFY(pair.writes.empty());
    pair.runFor(20ms);
    QCOMPARE(has(pair, kVelocity), 2.5);
}

void TestMcbSetPoints::aPositionIsNeverMapped()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    pair.writes.clear();
    QVERIFY(pair.ask(PositionRamp{1, 1.0, 500ms}).outcome == Outcome::Ok);
    QVERIFY(wrote(pair, kPosition));
}

void TestMcbSetPoints::theMotionLogHasTheFrame()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    pair.motions.clear();
    bench.keep = true;
    QVERIFY(pair.ask(SpeedRamp{1, 600, 0ms}).outcome == Outcome::Ok);
    QCOMPARE(pair.motions.size(), std::size_t{1});
    const auto &bytes = pair.motions.front().sent;
    QVERIFY(!bytes.empty());
    const auto logged = mcb::decodeFrame(bytes.back());
    QVERIFY(logged);
    QCOMPARE(bench.velocitySent(*logged), 10.0);
    QVERIFY(std::any_of(bench.sent.begin(), bench.sent.end(),
        [&](const mcb::Frame &frame) { return mcb::encodeFrame(frame) == bytes.back(); }));
}

void TestMcbSetPoints::signalsAreStreamedBesideThem()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    Stream stream;
    stream.fast = {pair.id("BUS_VOLTAGE")};
    QVERIFY(pair.ask(stream).outcome == Outcome::Ok);
    pair.runFor(100ms);
    QVERIFY(pair.blocks.size() > 2);
    QVERIFY(pair.ask(SpeedRamp{1, 600, 0ms}).outcome == Outcome::Ok);
    QCOMPARE(has(pair, kVelocity), 10.0);
    QVERIFY(pair.ask(Stream{}).outcome == Outcome::Ok); // the signals go, they stay
    QVERIFY(pair.board->slave().cyclic());
    QVERIFY(pair.ask(SpeedRamp{1, 300, 0ms}).outcome == Outcome::Ok);
    QCOMPARE(has(pair, kVelocity), 5.0);
    QCOMPARE(bench.told, std::vector<bool>{true});
}

void TestMcbSetPoints::signalsChangeWhileTheMotorTurns()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    QVERIFY(bench.turnAt(600));
    pair.runFor(1s);
    double least = 1e9;
    bench.keep = true;
    Stream stream;
    for (const char *name : {"BUS_VOLTAGE", "I_A", "SPEED_MEAS"}) {
        stream.fast.push_back(pair.id(name));
        QVERIFY(pair.ask(stream).outcome == Outcome::Ok);
        QVERIFY(pair.runUntil(
            [&] {
                least = std::min(least, has(pair, kVelocity));
                return pair.layout && pair.layout->slow.size() == stream.fast.size();
            },
            1s));
    }
    QCOMPARE(least, 10.0);
    for (const mcb::Frame &frame : bench.sent)
        QCOMPARE(bench.velocitySent(frame), 10.0);
    QVERIFY(pair.board->slave().cyclic());
    QVERIFY(pair.ask(SpeedRamp{1, 300, 0ms}).outcome == Outcome::Ok);
    QCOMPARE(has(pair, kVelocity), 5.0);
}

void TestMcbSetPoints::switchedOffTheDriveKeepsItsSetPoint()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    QVERIFY(bench.turnAt(600));
    QVERIFY(pair.ask(CyclicSetPoints{false}).outcome == Outcome::Ok);
    QCOMPARE(bench.told, (std::vector<bool>{true, false}));
    QVERIFY(!pair.board->slave().cyclic());
    QCOMPARE(has(pair, kVelocity), 10.0);
    pair.writes.clear();
    QVERIFY(pair.ask(SpeedRamp{1, 300, 0ms}).outcome == Outcome::Ok);
    QVERIFY(wrote(pair, kVelocity));
}

void TestMcbSetPoints::aStopPutsThemToRestWithItsFirstFrame()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    QVERIFY(bench.turnAt(600));
    // With another one on its way: the drive has it, the program has not read it back.
    const auto ramp = pair.submit(SpeedRamp{1, 1200, 0ms});
    QVERIFY(pair.runUntil([&] { return has(pair, kVelocity) == 20.0; }, 1s));
    QVERIFY(!pair.ended.contains(ramp));
    bench.sent.clear();
    bench.keep = true;
    pair.stopped = true;
    pair.drive->stop(pair.now);
    pair.exchange();
    QVERIFY(pair.runUntil([&] { return pair.stops.size() == 4; }, 10s));
    QVERIFY(bench.sent.size() > 10);
    QCOMPARE(bench.sent.front().address, kControl);
    QVERIFY(bench.sent.front().command == mcb::Command::Write);
    for (const mcb::Frame &frame : bench.sent)
        QCOMPARE(bench.velocitySent(frame), 0.0);
    QCOMPARE(pair.ended.at(ramp).size(), std::size_t{1});
    QVERIFY(pair.ended.at(ramp).front().outcome == Outcome::Unknown);
    // A start after it goes to nothing old.
    armServo(pair);
    QVERIFY(startServo(pair));
    pair.runFor(500ms);
    QCOMPARE(has(pair, kVelocity), 0.0);
    QVERIFY(std::abs(*pair.status->speedRpm) < 60.0);
    QVERIFY(pair.ask(SpeedRamp{1, 600, 0ms}).outcome == Outcome::Ok);
    QCOMPARE(has(pair, kVelocity), 10.0);
}

void TestMcbSetPoints::aFaultPutsThemToRest()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    QVERIFY(bench.turnAt(600));
    pair.board->setFaults(0x0002);
    QVERIFY(pair.runUntilState(MotorState::FaultOver));
    pair.runFor(20ms);
    QCOMPARE(has(pair, kVelocity), 0.0);
    pair.board->setFaults(0);
    pair.runFor(3s);
    QVERIFY(pair.drive->armed());
    QVERIFY(pair.ask(Command{MotorAction::AcknowledgeFaults, 1}).outcome == Outcome::Ok);
    QVERIFY(pair.runUntilState(MotorState::Idle));
    QVERIFY(startServo(pair));
    pair.runFor(500ms);
    QVERIFY(std::abs(*pair.status->speedRpm) < 60.0);
}

void TestMcbSetPoints::disarmingHoldsThem()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    QVERIFY(bench.turnAt(600));
    pair.drive->disarm();
    bench.keep = true;
    QVERIFY(pair.ask(SpeedRamp{1, 1200, 0ms}).outcome == Outcome::NotSent);
    pair.runFor(50ms);
    QVERIFY(!bench.sent.empty());
    for (const mcb::Frame &frame : bench.sent)
        QCOMPARE(bench.velocitySent(frame), 10.0);
    // Off is always possible.
    QVERIFY(pair.ask(CyclicSetPoints{false}).outcome == Outcome::Ok);
    QCOMPARE(has(pair, kVelocity), 10.0);
}

void TestMcbSetPoints::whatNoFrameHadNoneHasAfterwards_data()
{
    QTest::addColumn<int>("rpm"); // asked for while it turns at 600
    QTest::addColumn<std::function<void(McbPair &)>>("act");
    QTest::addColumn<bool>("rests"); // neither it nor the one before comes behind a Stop
    QTest::addColumn<Duration>("stall"); // that the judge allows
    using Act = std::function<void(McbPair &)>;
    QTest::newRow("disarmed") << 1200 << Act([](McbPair &pair) { pair.drive->disarm(); }) << false
                              << Duration();
    QTest::newRow("disconnected") << 1200
                                  << Act([](McbPair &pair) { pair.drive->disconnect(pair.now); })
                                  << false << Duration();
    QTest::newRow("stopped") << 1200 << Act([](McbPair &pair) {
        pair.stopped = true;
        pair.drive->stop(pair.now);
    }) << true << Duration();
    const Act late = [](McbPair &pair) {
        const Duration look = std::exchange(pair.look, 5ms);
        pair.stall(kStall);
        pair.look = look;
    };
    QTest::newRow("late") << 1200 << late << false << kStall;
    QTest::newRow("rest, late") << 0 << late << false << kStall;
}

/// At any instant of a set-point's way: between it and the next exchange it is taken back, or the program has no core
/// for longer than a wish lives.
void TestMcbSetPoints::whatNoFrameHadNoneHasAfterwards()
{
    QFETCH(const int, rpm);
    QFETCH(const std::function<void(McbPair &)>, act);
    QFETCH(const bool, rests);
    QFETCH(const Duration, stall);
    int notSent = 0;
    constexpr int kInstants = 60;
    for (int i = 0; i < kInstants; ++i) {
        SetPointBench bench({}, stall);
        bench.pair.look = 250us;
        QVERIFY(bench.travels());
        McbPair &pair = bench.pair;
        QVERIFY(bench.turnAt(600));
        bench.keep = true;
        const WishId ramp = pair.submit(SpeedRamp{1, rpm, 0ms});
        pair.runFor(i * 250us);
        const bool left = std::any_of(bench.sent.begin(), bench.sent.end(),
            [&](const mcb::Frame &frame) { return bench.velocitySent(frame) != 10.0; });
        bench.sent.clear();
        act(pair);
        pair.exchange();
        QVERIFY(pair.runUntilEnded(ramp));
        pair.runFor(20ms);
        QVERIFY(!bench.sent.empty());
        for (const mcb::Frame &frame : bench.sent)
            QCOMPARE(bench.velocitySent(frame), rests ? 0.0 : left ? rpm / 60.0 : 10.0);
        const Outcome outcome = pair.ended.at(ramp).front().outcome;
        QCOMPARE(outcome == Outcome::NotSent, !left);
        notSent += left ? 0 : 1;
    }
    QVERIFY(notSent > 0 && notSent < kInstants);
}

void TestMcbSetPoints::aResetEndsThem()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    Stream stream;
    stream.fast = {pair.id("BUS_VOLTAGE")};
    QVERIFY(pair.ask(stream).outcome == Outcome::Ok);
    QVERIFY(bench.turnAt(600));
    pair.board->reset();
    QVERIFY(pair.runUntil([&] { return pair.reason == LinkReason::BoardReset; }, 3s));
    QVERIFY(!pair.drive->armed());
    QCOMPARE(bench.told, (std::vector<bool>{true, false}));
    // The signals come again, without a set-point.
    bench.sent.clear();
    bench.keep = true;
    pair.blocks.clear();
    QVERIFY(pair.runUntil([&] { return pair.blocks.size() > 2; }, 5s));
    pair.runFor(100ms);
    QVERIFY(!bench.sent.empty());
    for (const mcb::Frame &frame : bench.sent)
        QCOMPARE(bench.velocitySent(frame), 0.0);
    QCOMPARE(has(pair, kVelocity), 0.0);
    QCOMPARE(bench.told.size(), std::size_t{2});
    armServo(pair);
    QVERIFY(startServo(pair));
    pair.runFor(500ms);
    QVERIFY(std::abs(*pair.status->speedRpm) < 60.0);
}

void TestMcbSetPoints::aProgramThatWasKilledRepeatsNothing()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    QVERIFY(bench.turnAt(600));
    pair.replaceDrive(makeMcbDrive({}));
    pair.identified.reset();
    bench.keep = true;
    QVERIFY(pair.meet());
    QVERIFY(!bench.sent.empty());
    for (const mcb::Frame &frame : bench.sent)
        QCOMPARE(bench.velocitySent(frame), 0.0);
    QVERIFY(!pair.board->slave().cyclic());
}

void TestMcbSetPoints::aLostLinkEndsThem()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    QVERIFY(bench.turnAt(600));
    bool dead = true;
    pair.toDrive = [&](Bytes &in) {
        if (dead)
            in.clear();
    };
    QVERIFY(pair.runUntil([&] { return pair.link == LinkState::Lost; }, 5s));
    QCOMPARE(bench.told, (std::vector<bool>{true, false}));
    QVERIFY(!pair.drive->armed());
    dead = false;
    bench.sent.clear();
    bench.keep = true;
    QVERIFY(pair.runUntil([&] { return pair.link == LinkState::Connected; }, 5s));
    QVERIFY(pair.runUntil([&] { return pair.identifications == 2; }, 5s));
    for (const mcb::Frame &frame : bench.sent)
        QCOMPARE(bench.velocitySent(frame), 0.0);
    QVERIFY(!pair.board->slave().cyclic());
    QCOMPARE(bench.told.size(), std::size_t{2});
}

void TestMcbSetPoints::damagedFramesChangeNothing()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    QVERIFY(bench.turnAt(600));
    // A burst in both directions that makes the master look for the length again.
    int damaged = 0;
    pair.toDrive = [&](Bytes &in) {
        if (damaged < 6 && !in.empty()) {
            in[in.size() / 2] ^= 0x10;
            ++damaged;
        }
    };
    double least = 1e9;
    QVERIFY(pair.runUntil(
        [&] {
            least = std::min(least, has(pair, kVelocity));
            return damaged == 6;
        },
        1s));
    pair.runFor(500ms);
    QCOMPARE(std::min(least, has(pair, kVelocity)), 10.0);
    QVERIFY(pair.counters.recoveries > 0);
    QVERIFY(pair.link == LinkState::Connected);
    QCOMPARE(bench.told, std::vector<bool>{true});
    QVERIFY(pair.ask(SpeedRamp{1, 300, 0ms}).outcome == Outcome::Ok);
    QCOMPARE(has(pair, kVelocity), 5.0);
}

void TestMcbSetPoints::anotherValueReadBackIsTold()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    // The drive answers every question for its velocity set-point with another value.
    pair.toDrive = [](Bytes &in) {
        auto frame = mcb::decodeFrame(in);
        if (!frame || frame->command != mcb::Command::Ack || frame->address != kVelocity)
            return;
        frame->config = {0, 0x4000, 0, 0}; // 2.0
        in = mcb::encodeFrame(*frame);
    };
    const auto done = pair.ask(SpeedRamp{1, 600, 0ms});
    QVERIFY(done.outcome == Outcome::Refused);
    QVERIFY2(
        done.reason.find("another value is read back") != std::string::npos, done.reason.c_str());
    bench.keep = true;
    pair.runFor(5ms);
    QVERIFY(!bench.sent.empty());
    for (const mcb::Frame &frame : bench.sent)
        QCOMPARE(bench.velocitySent(frame), 2.0); // it is left with what it says
}

void TestMcbSetPoints::disconnectingLeavesTheConfigState()
{
    SetPointBench bench;
    QVERIFY(bench.travels());
    McbPair &pair = bench.pair;
    QVERIFY(bench.turnAt(600));
    bench.keep = true;
    pair.drive->disconnect(pair.now);
    QVERIFY(pair.runUntil([&] { return pair.link == LinkState::Closed; }, 2s));
    QVERIFY(!pair.board->slave().cyclic());
    for (const mcb::Frame &frame : bench.sent)
        QCOMPARE(bench.velocitySent(frame), 10.0); // the user who disconnects decides for it
    QCOMPARE(bench.told, (std::vector<bool>{true, false}));
}

QTEST_GUILESS_MAIN(TestMcbSetPoints)
#include "tst_mcb_set_points.moc"
