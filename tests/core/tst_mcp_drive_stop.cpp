// The stop of McpDrive: first on the wire, repeated, and claimed only on evidence.
#include "drive/stop_sequence.h"
#include "support/link_pair.h"

#include <QTest>

using namespace drive;
using support::Session;
using namespace std::chrono_literals;

namespace {

constexpr auto kStop = mcp::CommandId::StopMotor;

MotorStatus statusOf(MotorState state, double rpm, TimePoint at, int motor = 1)
{
    MotorStatus status;
    status.motor = motor;
    status.state = state;
    status.speedRpm = rpm;
    status.at = at;
    return status;
}

std::vector<StopWord> words(StopSequence &stop)
{
    std::vector<StopWord> all;
    for (const StopProgress &progress : stop.takeProgress())
        all.push_back(progress.word);
    return all;
}

} // namespace

class TestMcpDriveStop : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void stopGoesFirstEvenWithARequestOpen();
    void onAnIdleLinkItLeavesAtOnce();
    void waitingWishesAreNotSentAndArmingIsNeededAgain();
    void aMutedBoardRaisesTheAlarmAfterHalfASecond();
    void theStopIsRepeatedUntilTheDriveIsIdle();
    void withoutALinkItIsSentBlindForTwoSeconds();
    void afterTheLinkIsBackTheStopGoesOn();
    void nothingButStopAndStatesLeavesWhileStopping();
    void evidenceFromBeforeTheStopCountsForNothing();
    void standstillNeedsThreeSlowReadingsInARow();
    void everyMotorIsStopped();
};

void TestMcpDriveStop::stopGoesFirstEvenWithARequestOpen()
{
    // At every phase of a request's life: the STOP is what leaves next.
    for (Duration when = 0us; when < 6ms; when += 250us) {
        Session session;
        QVERIFY(session.startMotor());
        session.submit(Read{{session.id("MOTOR_CONFIG")}});
        session.runFor(when);
        for (int i = 0; i < 10; ++i)
            session.submit(Write{{{session.id("SPEED_KP"), std::int64_t{1000 + i}}}});
        const std::size_t before = session.requests.size();
        session.drive->stop(session.now);
        session.exchange();
        const TimePoint asked = session.now;
        QVERIFY(
            session.runUntil([&] { return support::count(session.requests, kStop) > 0; }, 200ms));
        QVERIFY(session.now - asked <= 70ms);
        // At most the request whose header had left goes before it.
        QVERIFY(session.requests.size() <= before + 2);
        QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::DriveIdle); }, 5s));
    }
}

void TestMcpDriveStop::onAnIdleLinkItLeavesAtOnce()
{
    Session session;
    QVERIFY(session.startMotor());
    session.runUntil([&] { return session.drive->nextTimeout() > session.now + 50ms; }, 500ms);
    const TimePoint asked = session.now;
    session.drive->stop(session.now);
    session.exchange();
    QVERIFY(session.runUntil([&] { return support::count(session.requests, kStop) == 1; }, 100ms));
    QVERIFY(session.now - asked < 10ms);
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::Accepted); }, 20ms));
}

void TestMcpDriveStop::waitingWishesAreNotSentAndArmingIsNeededAgain()
{
    Session session;
    QVERIFY(session.startMotor());
    std::vector<WishId> wishes;
    for (int i = 0; i < 5; ++i) {
        wishes.push_back(session.submit(SpeedRamp{1, 100 * i, 100ms}));
        wishes.push_back(session.submit(Read{{session.id("BUS_VOLTAGE")}}));
    }
    session.drive->stop(session.now);
    session.exchange();
    session.runFor(300ms);
    for (std::size_t i = 1; i < wishes.size(); ++i) {
        QCOMPARE(session.ended[wishes[i]].size(), 1U);
        QVERIFY(session.outcome(wishes[i]) == Outcome::NotSent);
    }
    const WishId start = session.submit(Command{MotorAction::Start, 1});
    QVERIFY(session.outcome(start) == Outcome::NotSent);
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::Standstill); }, 10s));
    session.runFor(1s);
    QVERIFY(session.status[1].state == MotorState::Idle); // releasing restarts nothing
    session.drive->arm();
    QVERIFY(session.drive->armed());
    QVERIFY(session.startMotor());
}

void TestMcpDriveStop::aMutedBoardRaisesTheAlarmAfterHalfASecond()
{
    Session session;
    QVERIFY(session.startMotor());
    session.board->mute(1500ms);
    session.drive->stop(session.now);
    session.exchange();
    const TimePoint asked = session.now;
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::NotConfirmed); }, 1s));
    QVERIFY(session.now - asked >= 500ms && session.now - asked <= 510ms);
    QVERIFY(!session.hasStopWord(StopWord::DriveIdle));
    session.drive->arm();
    QVERIFY(!session.drive->armed()); // not before the stop is confirmed
    // It goes on trying, and says so when there is evidence.
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::DriveIdle); }, 5s));
}

void TestMcpDriveStop::theStopIsRepeatedUntilTheDriveIsIdle()
{
    Session session;
    QVERIFY(session.runAt(1500));
    session.toBoard.cut = true;
    session.drive->stop(session.now);
    session.exchange();
    session.runFor(400ms);
    QVERIFY(support::count(session.requests, kStop) >= 2);
    session.toBoard.cut = false;
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::DriveIdle); }, 5s));
    session.runFor(200ms);
    const std::size_t then = support::count(session.requests, kStop);
    session.runFor(1s);
    QCOMPARE(support::count(session.requests, kStop), then);
}

void TestMcpDriveStop::withoutALinkItIsSentBlindForTwoSeconds()
{
    Session session;
    QVERIFY(session.startMotor());
    session.toDrive.cut = session.toBoard.cut = true;
    QVERIFY(session.runUntil([&] { return session.link == LinkState::Lost; }, 3s));
    const std::size_t before = support::count(session.requests, kStop);
    session.drive->stop(session.now);
    session.exchange();
    session.runFor(2s);
    const std::size_t blind = support::count(session.requests, kStop) - before;
    QVERIFY2(blind >= 10 && blind <= 21, std::to_string(blind).c_str());
    QVERIFY(session.hasStopWord(StopWord::NotConfirmed));
    session.runFor(3s);
    QVERIFY(support::count(session.requests, kStop) - before <= blind + 1);
}

void TestMcpDriveStop::afterTheLinkIsBackTheStopGoesOn()
{
    Session session;
    QVERIFY(session.startMotor());
    session.toDrive.cut = session.toBoard.cut = true;
    QVERIFY(session.runUntil([&] { return session.link == LinkState::Lost; }, 3s));
    session.drive->stop(session.now);
    session.exchange();
    session.runFor(4s);
    session.toDrive.cut = session.toBoard.cut = false;
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::DriveIdle); }, 5s));
    QVERIFY(session.status[1].state == MotorState::Idle);
}

void TestMcpDriveStop::nothingButStopAndStatesLeavesWhileStopping()
{
    Session session;
    QVERIFY(session.runAt(1500));
    session.submit(Watch{{session.id("BUS_VOLTAGE")}, 10ms});
    session.runFor(100ms);
    session.toDrive.cut = true;
    session.drive->stop(session.now);
    session.exchange();
    session.runFor(20ms); // what had left already
    const std::size_t before = session.requests.size();
    session.submit(Read{{session.id("BUS_VOLTAGE")}});
    session.submit(Stream{{session.id("I_A")}, 1, {}, 1});
    session.runFor(1s);
    QVERIFY(session.requests.size() > before);
    for (std::size_t i = before; i < session.requests.size(); ++i) {
        const auto request = mcp::decodeRequest(session.requests[i]);
        const Bytes states{0x10, 0x00, 0x19, 0x00, 0x59, 0x00, 0x49, 0x00};
        QVERIFY(
            request->command == static_cast<std::uint16_t>(kStop) || session.requests[i] == states);
    }
}

void TestMcpDriveStop::evidenceFromBeforeTheStopCountsForNothing()
{
    const TimePoint t{10s};
    StopSequence stop;
    stop.begin(1, t);
    QVERIFY((words(stop) == std::vector<StopWord>{StopWord::Requested}));
    stop.takeStatus(statusOf(MotorState::Idle, 0, t + 2ms), t - 1ms);
    QVERIFY(words(stop).empty());
    QCOMPARE(stop.stopDue(t, true), std::optional<int>(1));
    stop.stopSent(1, t + 3ms);
    stop.takeStatus(statusOf(MotorState::Idle, 0, t + 4ms), t + 2ms);
    QVERIFY(words(stop).empty());
    stop.takeStatus(statusOf(MotorState::Running, 1000, t + 6ms), t + 5ms);
    QVERIFY(words(stop).empty());
    stop.takeStatus(statusOf(MotorState::FaultOver, 1000, t + 8ms), t + 7ms);
    QVERIFY(words(stop).empty());
    stop.takeStatus(statusOf(MotorState::FaultOver, 1000, t + 8ms), t + 7ms);
    QVERIFY((words(stop) == std::vector<StopWord>{StopWord::DriveIdle}));
    QVERIFY(!stop.exclusive());
    QVERIFY(stop.active());
    stop.handleTimeout(t + 1s);
    QVERIFY(words(stop).empty());
}

void TestMcpDriveStop::standstillNeedsThreeSlowReadingsInARow()
{
    const TimePoint t{10s};
    StopSequence stop;
    stop.begin(1, t);
    stop.stopSent(1, t);
    static_cast<void>(stop.takeProgress());
    for (const double rpm : {300.0, 300.0, 5.0, -5.0, 20.0, 5.0, 9.0})
        stop.takeStatus(statusOf(MotorState::Idle, rpm, t + 1ms), t + 1ms);
    QVERIFY((words(stop) == std::vector<StopWord>{StopWord::DriveIdle}));
    stop.takeStatus(statusOf(MotorState::Idle, -9.0, t + 2ms), t + 2ms);
    QVERIFY((words(stop) == std::vector<StopWord>{StopWord::Standstill}));
    QVERIFY(!stop.active());
}

void TestMcpDriveStop::everyMotorIsStopped()
{
    const TimePoint t{10s};
    StopSequence stop;
    stop.begin(2, t);
    QCOMPARE(words(stop).size(), 2U);
    QCOMPARE(stop.stopDue(t, true), std::optional<int>(1));
    stop.stopSent(1, t);
    QCOMPARE(stop.stopDue(t, true), std::optional<int>(2));
    stop.stopSent(2, t);
    QVERIFY(!stop.stopDue(t + 99ms, true));
    stop.takeStatus(statusOf(MotorState::Idle, 0, t + 1ms, 1), t + 1ms);
    stop.takeStatus(statusOf(MotorState::Idle, 0, t + 2ms, 1), t + 2ms);
    QVERIFY(stop.exclusive());
    QCOMPARE(stop.stopDue(t + 100ms, true), std::optional<int>(2));
    static_cast<void>(stop.takeProgress());
    stop.handleTimeout(t + 499ms);
    QVERIFY(words(stop).empty());
    stop.handleTimeout(t + 500ms);
    const auto alarms = stop.takeProgress();
    QCOMPARE(alarms.size(), 1U);
    QCOMPARE(alarms[0].motor, 2);
    QVERIFY(alarms[0].word == StopWord::NotConfirmed);
}

QTEST_APPLESS_MAIN(TestMcpDriveStop)
#include "tst_mcp_drive_stop.moc"
