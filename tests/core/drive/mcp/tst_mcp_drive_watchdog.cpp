// The heartbeat of McpDrive and the watchdog of the simulated board: who is fed, when, and what happens to who is not.
#include "drive/mcp/heartbeat.h"
#include "support/board_bench.h"
#include "support/link_pair.h"

#include <QTest>

using namespace drive;
using support::Session;
using namespace std::chrono_literals;

namespace {

constexpr int kTimeOut_ms = 500;
const Bytes kHeartbeat{0x09, 0x01, 0xF4, 0x01}; // (33 << 3) | 1, 500

simulation::BoardOptions withWatchdog(int time_ms = kTimeOut_ms)
{
    simulation::BoardOptions options;
    options.watchdogMs = time_ms;
    return options;
}

std::size_t userCommands(const std::vector<Bytes> &requests, std::size_t from = 0)
{
    const auto all = support::commandsIn(requests);
    return static_cast<std::size_t>(std::count_if(all.begin() + static_cast<std::ptrdiff_t>(from),
        all.end(), [](std::uint16_t command) { return command >= 32; }));
}

} // namespace

class TestMcpDriveWatchdog : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void onlyANameThatEndsInTheMarkHasOne();
    void theIdentitySaysIt();
    void withHeartbeatsTheMotorRunsOn();
    void disarmedItIsNotFed();
    void everyHeartbeatIsTheOneOfTheContract();
    void heartbeatsDoNotWaitBehindWatchedRegistersAndSamples();
    void withTheLinkCutTheBoardStopsWithinTheTimeOut();
    void aBoardWithoutTheMarkNeverGetsOne();
    void noneBeforeArmingWithAnIdleMotor();
    void whoOnlyLooksOnKeepsNoMotorAlive();
    void armingTakesOverWhatRuns();
    void noneFromTheStopToItsConfirmation();
    void anUnconfirmedStopIsFinishedByTheWatchdog();
    void aBoardThatRefusesIsLeftAlone();
    void aHeartbeatWithAnotherTimeFeedsNothing();
};

void TestMcpDriveWatchdog::onlyANameThatEndsInTheMarkHasOne()
{
    QVERIFY(watchdogIn("ST MC SDK\tVer.6.4.0 RSWD500") == 500ms);
    QVERIFY(watchdogIn(" RSWD100") == 100ms);
    QVERIFY(watchdogIn("a RSWD1 b RSWD60000") == 60s);
    for (const char *name :
        {"", "ST MC SDK\tVer.6.4.0", "x RSWD", "xRSWD500", "x RSWD500 ", "x RSWD500a", "x RSWD 500",
            "x RSWD+500", "x RSWD-500", "x RSWD0500", "x RSWD0", "x RSWD99", "x RSWD60001",
            "x RSWD99999999999999999999", "x rswd500", "x RSWD500 RSWDx"})
        QVERIFY2(!watchdogIn(name), name);
}

void TestMcpDriveWatchdog::theIdentitySaysIt()
{
    Session with(false, withWatchdog());
    QVERIFY(with.ready);
    QVERIFY(with.identified->identity.watchdog == 500ms);
    Session without(false);
    QVERIFY(without.ready);
    QVERIFY(!without.identified->identity.watchdog);
}

void TestMcpDriveWatchdog::withHeartbeatsTheMotorRunsOn()
{
    Session session(true, withWatchdog());
    QVERIFY(session.runAt(1500));
    for (int i = 0; i < 50; ++i) {
        session.runFor(100ms);
        QVERIFY(session.status[1].state == MotorState::Running);
    }
}

void TestMcpDriveWatchdog::disarmedItIsNotFed()
{
    Session session(true, withWatchdog());
    QVERIFY(session.runAt(1500));
    session.drive->disarm();
    session.runFor(1ms); // what had left already
    const std::size_t then = session.requests.size();
    session.runFor(3s);
    QCOMPARE(userCommands(session.requests, then), std::size_t{0});
    QVERIFY(session.status[1].state == MotorState::Idle); // by the board itself
    QCOMPARE(support::count(session.requests, mcp::CommandId::StopMotor), std::size_t{0});
}

void TestMcpDriveWatchdog::everyHeartbeatIsTheOneOfTheContract()
{
    Session session(true, withWatchdog());
    const std::size_t before = session.requests.size();
    session.runFor(3s);
    const std::size_t sent = userCommands(session.requests, before);
    QVERIFY2(sent >= 17 && sent <= 19, std::to_string(sent).c_str()); // one in 166.7 ms
    for (const Bytes &request : session.requests)
        if (mcp::decodeRequest(request)->command >= 32)
            QCOMPARE(request, kHeartbeat);
    QVERIFY(session.status[1].state == MotorState::Idle); // it starts nothing
}

void TestMcpDriveWatchdog::heartbeatsDoNotWaitBehindWatchedRegistersAndSamples()
{
    Session session(true, withWatchdog());
    QVERIFY(session.startMotor());
    session.submit(Stream{{session.id("I_A"), session.id("I_B")}, 1, {}, 1});
    std::vector<RegisterId> many;
    for (const char *name : {"BUS_VOLTAGE", "HEATS_TEMP", "SPEED_KP", "SPEED_KI", "I_Q_MEAS"})
        many.push_back(session.id(name));
    session.submit(Watch{many, 1ms});
    for (int i = 0; i < 10; ++i) {
        const std::size_t before = session.requests.size();
        session.runFor(300ms);
        QVERIFY(userCommands(session.requests, before) >= 1);
    }
    QVERIFY(session.status[1].state == MotorState::Running);
}

void TestMcpDriveWatchdog::withTheLinkCutTheBoardStopsWithinTheTimeOut()
{
    Session session(true, withWatchdog());
    QVERIFY(session.runAt(1500));
    session.toBoard.cut = true; // what the board says still arrives, if it says anything
    session.runFor(kTimeOut_ms * 1ms + 500ms); // and the 0.4 s that its stop takes
    session.toBoard.cut = false;
    QVERIFY(session.runUntil([&] { return session.status[1].at > session.now - 50ms; }, 5s));
    QVERIFY(session.status[1].state == MotorState::Idle);
    QCOMPARE(support::count(session.requests, mcp::CommandId::StopMotor), std::size_t{0});

    Session without;
    QVERIFY(without.runAt(1500));
    without.toBoard.cut = true;
    without.runFor(kTimeOut_ms * 1ms + 500ms);
    without.toBoard.cut = false;
    QVERIFY(without.runUntil([&] { return without.status[1].at > without.now - 50ms; }, 5s));
    QVERIFY(without.status[1].state == MotorState::Running);
}

void TestMcpDriveWatchdog::aBoardWithoutTheMarkNeverGetsOne()
{
    simulation::BoardOptions options;
    options.userCallbacks = 2; // it would take them
    Session session(true, options);
    QVERIFY(session.runAt(1500));
    session.runFor(2s);
    session.drive->stop(session.now);
    session.exchange();
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::MayCoast); }, 10s));
    session.drive->arm();
    session.runFor(1s);
    QCOMPARE(userCommands(session.requests), std::size_t{0});
}

void TestMcpDriveWatchdog::noneBeforeArmingWithAnIdleMotor()
{
    Session session(false, withWatchdog());
    QVERIFY(session.ready);
    session.runFor(3s);
    QCOMPARE(userCommands(session.requests), std::size_t{0});
    session.drive->arm();
    session.runFor(1s);
    QVERIFY(userCommands(session.requests) >= 5);
    session.drive->disarm();
    session.runFor(1ms);
    const std::size_t then = session.requests.size();
    session.runFor(1s);
    QCOMPARE(userCommands(session.requests, then), std::size_t{0});
}

void TestMcpDriveWatchdog::whoOnlyLooksOnKeepsNoMotorAlive()
{
    Session session(true, withWatchdog(5000));
    QVERIFY(session.runAt(1500));
    session.drive->disconnect(session.now);
    session.exchange();
    session.runFor(100ms);
    const std::size_t before = session.requests.size();
    session.connect();
    session.runFor(1s);
    QVERIFY(session.status[1].state == MotorState::Running);
    session.runFor(11s);
    QVERIFY(!session.drive->armed());
    QCOMPARE(userCommands(session.requests, before), std::size_t{0});
    QVERIFY(session.status[1].state == MotorState::Idle);
}

void TestMcpDriveWatchdog::armingTakesOverWhatRuns()
{
    Session session(true, withWatchdog(5000));
    QVERIFY(session.runAt(1500));
    session.drive->disconnect(session.now);
    session.exchange();
    session.runFor(100ms);
    session.connect();
    session.runFor(1s);
    session.drive->arm();
    session.runFor(11s);
    QVERIFY(session.status[1].state == MotorState::Running);
}

void TestMcpDriveWatchdog::noneFromTheStopToItsConfirmation()
{
    // At every phase of a period, with the answers lost so that the confirmation takes long.
    for (Duration when = 0ms; when < 170ms; when += 10ms) {
        Session session(true, withWatchdog());
        QVERIFY(session.startMotor());
        session.runFor(when);
        session.board->mute(700ms);
        session.drive->stop(session.now);
        session.exchange();
        session.runFor(5ms); // what had left already
        const std::size_t before = session.requests.size();
        QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::MayCoast); }, 10s));
        QCOMPARE(userCommands(session.requests, before), std::size_t{0});
        QVERIFY(support::count(session.requests, mcp::CommandId::StopMotor) >= 2);
        session.runFor(1s);
        QCOMPARE(userCommands(session.requests, before), std::size_t{0}); // idle and not armed
    }
}

void TestMcpDriveWatchdog::anUnconfirmedStopIsFinishedByTheWatchdog()
{
    Session session(true, withWatchdog());
    QVERIFY(session.runAt(1500));
    session.loses = [&](const Bytes &bytes) { // the STOPs, and nothing else, never arrive
        return bytes == Bytes{0x21, 0x00};
    };
    session.drive->stop(session.now);
    session.exchange();
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::DriveIdle); }, 5s));
    QVERIFY(support::count(session.requests, mcp::CommandId::StopMotor) >= 2);
}

void TestMcpDriveWatchdog::aBoardThatRefusesIsLeftAlone()
{
    Session session(false, withWatchdog());
    QVERIFY(session.ready);
    QVERIFY(session.identified->identity.watchdog);
    // The number is damaged on its way, so the board says NOK each time.
    session.loses = [&](const Bytes &bytes) {
        if (bytes != kHeartbeat)
            return false;
        session.board->receive(Bytes{0x09, 0x01, 0xF5, 0x01}, session.now);
        return true;
    };
    session.drive->arm();
    session.runFor(3s);
    QCOMPARE(userCommands(session.requests), std::size_t{3});
    QVERIFY(!session.identified->identity.watchdog); // nothing is claimed any more
    QVERIFY(session.drive->armed());
}

void TestMcpDriveWatchdog::aHeartbeatWithAnotherTimeFeedsNothing()
{
    for (const bool fed : {true, false}) {
        support::BoardBench bench(withWatchdog());
        QVERIFY(bench.connect());
        QCOMPARE(bench.command(3), Bytes{0});
        QVERIFY(bench.waitForState(6));
        for (int i = 0; i < 10; ++i) {
            const Bytes answer = bench.ask(ByteWriter().u16(0x0109).u16(fed ? 500 : 499).take());
            QCOMPARE(answer, Bytes{static_cast<std::uint8_t>(fed ? 0 : 1)});
            bench.packets(80ms);
        }
        QCOMPARE(bench.get(mcp::reg::kStatus), fed ? 6 : 0);
    }
}

QTEST_APPLESS_MAIN(TestMcpDriveWatchdog)
#include "tst_mcp_drive_watchdog.moc"
