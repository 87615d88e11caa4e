// The stop of McpDrive: first on the wire, repeated, and claimed only on evidence.
#include "support/link_pair.h"

#include <QTest>

using namespace drive;
using support::Session;
using namespace std::chrono_literals;

namespace {

constexpr auto kStop = mcp::CommandId::StopMotor;

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
    void aStopOutlivesTheEndOfItsLink();
    void nothingButStopAndStatesLeavesWhileStopping();
    void aBoardThatDoesNotObeyIsAskedForNothingElse();
    void aMotorThatBecomesKnownWhileStoppingIsStoppedFirst();
    void aMotorThatBecomesKnownIsStoppedThoughAnotherNeverIs();
    void pressingAgainAndAgainHidesNoAlarm();
    void aLostLinkIsToldWhileAPersonKeepsPressing();
    void blindStopsReachEveryMotor();
    void noBlindStopTakesTheLineFromAnother();
    void aStopInterruptsTheDisconnecting();
    void whatWaitsToLeaveIsDroppedBeforeABlindStop();
    void withAnEncoderStandstillIsMeasured();
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
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::MayCoast); }, 10s));
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

void TestMcpDriveStop::aStopOutlivesTheEndOfItsLink()
{
    // Asked for shortly before the link is given up, whose end drops what has not left yet.
    Duration lost{};
    for (Duration before = 0ms; before < 60ms; before += 2ms) {
        Session session;
        QVERIFY(session.startMotor());
        session.toDrive.cut = true;
        const TimePoint cut = session.now;
        if (before == 0ms) {
            QVERIFY(session.runUntil([&] { return session.link == LinkState::Lost; }, 5s));
            lost = session.now - cut;
            continue;
        }
        const Duration silence = lost - before;
        session.runFor(silence);
        const std::size_t stops = support::count(session.requests, kStop);
        session.drive->stop(session.now);
        session.exchange();
        QVERIFY2(
            session.runUntil([&] { return support::count(session.requests, kStop) > stops; }, 80ms),
            std::to_string(toSeconds(silence)).c_str());
    }
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

namespace {

simulation::BoardOptions twoMotors()
{
    simulation::BoardOptions options;
    options.motors = 2;
    return options;
}

Bytes stopOf(unsigned motor)
{
    return ByteWriter().u16(static_cast<unsigned>(kStop) << 3 | motor).take();
}

bool bothRun(Session &session)
{
    for (const int motor : {1, 2})
        session.submit(Command{MotorAction::Start, motor});
    return session.runUntil(
        [&] {
            return session.status[1].state == MotorState::Running
                && session.status[2].state == MotorState::Running;
        },
        10s);
}

bool hasWord(const Session &session, StopWord word, int motor)
{
    return std::any_of(session.stops.begin(), session.stops.end(),
        [&](const StopProgress &one) { return one.motor == motor && one.word == word; });
}

/// A new drive on the same line, as after a port was opened again.
void meetAnew(Session &session)
{
    session.replaceDrive(makeMcpDrive({.baud = session.baud}));
    session.requests.clear();
    session.stops.clear();
    session.status.clear();
    session.connect();
}

} // namespace

void TestMcpDriveStop::aBoardThatDoesNotObeyIsAskedForNothingElse()
{
    Session session;
    QVERIFY(session.runAt(1500));
    session.submit(Watch{{session.id("BUS_VOLTAGE")}, 10ms});
    session.runFor(100ms);
    const Bytes header{0x29, 0x00, 0x00, 0xE0}; // of two bytes
    session.loses = [&](const Bytes &bytes) { return bytes == header || bytes == stopOf(1); };
    session.drive->stop(session.now);
    session.exchange();
    session.runFor(1500ms); // what else leaves is what the judge looks at
    QVERIFY(hasWord(session, StopWord::NotConfirmed, 1));
    QVERIFY(support::count(session.requests, kStop) >= 10);
    session.loses = {};
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::DriveIdle); }, 1s));
}

void TestMcpDriveStop::aMotorThatBecomesKnownWhileStoppingIsStoppedFirst()
{
    Session session(true, twoMotors());
    QVERIFY(bothRun(session));
    meetAnew(session);
    session.drive->stop(session.now);
    QVERIFY(session.drive->stopOpen());
    session.exchange();
    QVERIFY(session.runUntil([&] { return !session.drive->stopOpen(); }, 2s));
    QVERIFY(hasWord(session, StopWord::DriveIdle, 1) && hasWord(session, StopWord::DriveIdle, 2));
    // STOP of motor 1, how many there are, STOP of motor 2; states are read in between at most.
    const Bytes count = ByteWriter().u16(2U << 3).u16(mcp::reg::kGlobalConfig.bits).take();
    const auto at = [&](const Bytes &request) {
        return std::find(session.requests.begin(), session.requests.end(), request);
    };
    QVERIFY(at(stopOf(1)) < at(count));
    QVERIFY(at(count) < at(stopOf(2)));
    QVERIFY(at(stopOf(2)) != session.requests.end());
    for (auto request = session.requests.begin(); request < at(stopOf(2)); ++request)
        QVERIFY(*request == stopOf(1) || *request == count);
    QVERIFY(session.runUntil(
        [&] { return session.status.contains(2) && session.status[2].state == MotorState::Idle; },
        2s));
}

void TestMcpDriveStop::aMotorThatBecomesKnownIsStoppedThoughAnotherNeverIs()
{
    Session session(true, twoMotors());
    QVERIFY(bothRun(session));
    meetAnew(session);
    session.loses = [](const Bytes &bytes) { return bytes == stopOf(1); };
    session.drive->stop(session.now);
    session.exchange();
    QVERIFY(session.runUntil([&] { return hasWord(session, StopWord::DriveIdle, 2); }, 800ms));
    QVERIFY(!hasWord(session, StopWord::DriveIdle, 1));
    QVERIFY(session.drive->stopOpen());
    session.drive->arm();
    QVERIFY(!session.drive->armed());
    session.loses = {};
    QVERIFY(session.runUntil([&] { return !session.drive->stopOpen(); }, 5s));
    QVERIFY(hasWord(session, StopWord::NotConfirmed, 1));
}

void TestMcpDriveStop::pressingAgainAndAgainHidesNoAlarm()
{
    Session session;
    QVERIFY(session.startMotor());
    session.toDrive.cut = session.toBoard.cut = true;
    const TimePoint asked = session.now;
    for (int press = 0; press < 5; ++press) {
        session.drive->stop(session.now);
        session.exchange();
        if (session.runUntil([&] { return session.hasStopWord(StopWord::NotConfirmed); }, 400ms))
            break;
    }
    QVERIFY(session.hasStopWord(StopWord::NotConfirmed));
    QVERIFY(session.now - asked >= 500ms && session.now - asked <= 510ms);
    QCOMPARE(session.stops.size(), 2U); // requested once
}

void TestMcpDriveStop::aLostLinkIsToldWhileAPersonKeepsPressing()
{
    Session session;
    QVERIFY(session.startMotor());
    session.toDrive.cut = session.toBoard.cut = true;
    const TimePoint asked = session.now;
    std::optional<TimePoint> suspect, lost;
    session.onEvent = [&](const Event &event) {
        const auto *change = std::get_if<LinkChanged>(&event);
        if (change != nullptr && change->state == LinkState::Suspect && !suspect)
            suspect = session.now;
        if (change != nullptr && change->state == LinkState::Lost && !lost)
            lost = session.now;
    };
    for (int press = 0; press < 15; ++press) {
        session.drive->stop(session.now);
        session.exchange();
        session.runFor(400ms);
    }
    QVERIFY(suspect && *suspect - asked <= 600ms);
    QVERIFY(lost && *lost - asked <= 1200ms);
    session.toDrive.cut = session.toBoard.cut = false;
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::DriveIdle); }, 5s));
}

void TestMcpDriveStop::blindStopsReachEveryMotor()
{
    Session session(true, twoMotors());
    QVERIFY(bothRun(session));
    session.toDrive.cut = true; // the board hears, and is not heard
    session.requests.clear();
    session.drive->stop(session.now);
    session.exchange();
    session.runFor(1s);
    for (const unsigned motor : {1U, 2U})
        QVERIFY(std::count(session.requests.begin(), session.requests.end(), stopOf(motor)) >= 3);
    session.toDrive.cut = false;
    QVERIFY(session.runUntil([&] { return !session.drive->stopOpen(); }, 3s));
}

/// Behind a request that is never answered: 40 ms for its answer, 20 for the echo of a Beacon, and they leave.
void TestMcpDriveStop::noBlindStopTakesTheLineFromAnother()
{
    Session session(true, twoMotors());
    QVERIFY(bothRun(session));
    session.toDrive.cut = true;
    session.submit(Read{{session.id("MOTOR_CONFIG")}});
    session.requests.clear();
    session.drive->stop(session.now);
    session.exchange();
    const TimePoint asked = session.now;
    const auto left = [&](unsigned motor) {
        return std::count(session.requests.begin(), session.requests.end(), stopOf(motor)) > 0;
    };
    QVERIFY(session.runUntil([&] { return left(1); }, 200ms));
    QVERIFY2(!left(2) && session.now - asked <= 80ms,
        qPrintable(QString::number(toSeconds(session.now - asked))));
    QVERIFY(session.runUntil([&] { return left(2); }, 200ms));
    QVERIFY2(
        session.now - asked <= 120ms, qPrintable(QString::number(toSeconds(session.now - asked))));
    session.toDrive.cut = false;
    QVERIFY(session.runUntil([&] { return !session.drive->stopOpen(); }, 3s));
}

void TestMcpDriveStop::aStopInterruptsTheDisconnecting()
{
    Session session;
    QVERIFY(session.startMotor());
    session.submit(Stream{{session.id("I_A")}, 1, {}, 1});
    session.runFor(100ms);
    session.toDrive.cut = true; // so that the end of the stream is not acknowledged
    session.drive->disconnect(session.now);
    session.exchange();
    session.runFor(10ms);
    QVERIFY(session.link != LinkState::Closed);
    session.toDrive.cut = false;
    session.drive->stop(session.now);
    session.exchange();
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::DriveIdle); }, 1s));
    QVERIFY(session.status[1].state == MotorState::Idle);
    session.drive->disconnect(session.now);
    QVERIFY(session.runUntil([&] { return session.link == LinkState::Closed; }, 1s));
}

void TestMcpDriveStop::whatWaitsToLeaveIsDroppedBeforeABlindStop()
{
    const auto drops = [](const std::vector<Output> &outputs) {
        return std::any_of(
            outputs.begin(), outputs.end(), [](const Output &one) { return one.dropsEarlier; });
    };
    Session idle;
    QVERIFY(idle.startMotor());
    idle.runUntil([&] { return idle.drive->nextTimeout() > idle.now + 50ms; }, 500ms);
    idle.drive->stop(idle.now);
    QVERIFY(!drops(idle.drive->takeOutput())); // the line is clean: nothing waits

    Session stalled;
    QVERIFY(stalled.startMotor());
    stalled.submit(Command{MotorAction::StopRamp, 1}); // never leaves
    static_cast<void>(stalled.drive->takeOutput());
    stalled.drive->stop(stalled.now);
    bool dropped = false;
    for (int ms = 0; ms < 60 && !dropped; ++ms) {
        stalled.now += 1ms;
        stalled.drive->handleTimeout(stalled.now);
        const std::vector<Output> outputs = stalled.drive->takeOutput();
        QVERIFY(outputs.empty() || outputs.front().dropsEarlier); // at the first byte
        dropped = !outputs.empty();
    }
    QVERIFY(dropped);
}

void TestMcpDriveStop::withAnEncoderStandstillIsMeasured()
{
    simulation::BoardOptions options;
    options.motor = "servo24";
    for (const auto &option : simulation::buildOptions())
        if (option.name == "encoder" || option.name == "position")
            options.with.push_back(&option);
    Session session(true, options);
    QVERIFY(session.startMotor());
    QVERIFY(session.status[1].speedMeasured == std::optional(true));
    session.drive->stop(session.now);
    session.exchange();
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::Standstill); }, 20s));
    QVERIFY(!session.hasStopWord(StopWord::MayCoast));
}

QTEST_APPLESS_MAIN(TestMcpDriveStop)
#include "tst_mcp_drive_stop.moc"
