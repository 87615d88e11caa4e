// The session's pump on virtual time: what goes to the port when, what comes back, and how a port
// ends.
#include "fakes.h"

#include <QtTest>

using namespace fakes;
using session::PortProblem;
using session::PortState;
using Port = std::pair<PortState, PortProblem>;

class TestSession : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void outputsKeepTheirGapsOnTheWire();
    void aPortThatIsSlowerThanItsSpeedDelaysTheGap();
    void theDriveHearsThatItsOutputHasLeft();
    void bytesReachTheDriveAndItsEventsComeOut();
    void theDrivesTimeoutIsKept();
    void aStopFromAnotherThreadReachesTheDriveBeforeQueuedWishes();
    void aStopWithoutAPortDoesNothing();
    void wishesWithoutAPortEndNotSent();
    void armingIsToldAndEndsWithTheStop();
    void aPortThatCannotBeOpenedIsToldOnce();
    void closingWaitsForTheLastWordsButNotForLong();
    void closingEndsAtOnceWhenTheDriveIsSilent();
    void openingAnOpenSessionClosesItFirst();
    void anUnpluggedPortIsToldOnceAndTheDriveIsToldToo();
    void anUnpluggedPortIsTriedAgainEveryHalfSecond();
    void reopeningTakesUpStreamingAndNothingElse();
    void ownLimitsAreGivenToEveryDriveFirst();
    void closingEndsTheAttemptsToReopen();
    void aStalledReceiverGetsNoThirdBatch();
    void theSessionCanBeClosedFromWithinABatch();
};

void TestSession::outputsKeepTheirGapsOnTheWire()
{
    Bench bench;
    bench.session.open(Bench::serial());
    const TimePoint start = bench.now;
    bench.drive().outputs = {{bytes({1, 2, 3, 4}), {}}, {bytes({5}), 1500us}};
    bench.turn();
    QCOMPARE(bench.port.written.size(), 1U);
    bench.runUntil(start + 10ms);
    QCOMPARE(bench.port.written.size(), 2U);
    QCOMPARE(bench.port.written[1].at, start + 40us + 1500us); // 4 bytes at 1 Mbaud, then the pause
}

void TestSession::aPortThatIsSlowerThanItsSpeedDelaysTheGap()
{
    Bench bench;
    bench.session.open(Bench::serial());
    const TimePoint start = bench.now;
    bench.drive().outputs = {{bytes({1, 2, 3, 4}), {}}, {bytes({5}), 1500us}};
    bench.port.sent = false;
    bench.runUntil(start + 5ms);
    QCOMPARE(bench.port.written.size(), 1U);
    bench.port.sent = true;
    bench.runUntil(start + 10ms);
    QCOMPARE(bench.port.written.size(), 2U);
    QVERIFY(bench.port.written[1].at >= start + 5ms);
}

void TestSession::theDriveHearsThatItsOutputHasLeft()
{
    Bench bench;
    bench.session.open(Bench::serial());
    const TimePoint start = bench.now;
    bench.drive().outputs = {{Bytes(100), {}}};
    bench.turn();
    QVERIFY(bench.board.sentAt.empty());
    bench.runUntil(start + 10ms);
    QCOMPARE(bench.board.sentAt, std::vector<TimePoint>{start + 1ms});
}

void TestSession::bytesReachTheDriveAndItsEventsComeOut()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.drive().events.push_back(drive::LinkCounters{});
    bench.port.alive->hear("ab");
    QCOMPARE(bench.board.received, bytes({'a', 'b'}));
    QCOMPARE(bench.told<drive::LinkCounters>().size(), 1U);
}

void TestSession::theDrivesTimeoutIsKept()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.drive().timeout = bench.now + 7ms;
    bench.turn();
    QCOMPARE(*bench.session.nextStep(), bench.now + 7ms);
    bench.runUntil(bench.now + 7ms);
    QVERIFY(!bench.drive().timeout);
}

void TestSession::aStopFromAnotherThreadReachesTheDriveBeforeQueuedWishes()
{
    Bench bench;
    bench.session.open(Bench::serial());
    QMetaObject::invokeMethod(
        &bench.session,
        [&] {
            QCOMPARE(bench.board.stops, 1);
            bench.session.submit({});
        },
        Qt::QueuedConnection);
    QThread *other = QThread::create([&] { bench.session.stopFromAnyThread(); });
    other->start();
    other->wait();
    delete other;
    QCOMPARE(bench.board.stops, 0);
    QCoreApplication::sendPostedEvents(&bench.session);
    QCOMPARE(bench.board.stops, 1);
    QCOMPARE(bench.board.wishes.size(), 1U);
}

void TestSession::aStopWithoutAPortDoesNothing()
{
    Bench bench;
    bench.session.stop();
    bench.session.open(Bench::serial());
    bench.turn();
    QCOMPARE(bench.board.stops, 0);
}

void TestSession::wishesWithoutAPortEndNotSent()
{
    Bench bench;
    bench.session.submit({.id = 5, .what = drive::Read{}});
    const auto ends = bench.told<drive::Ended>();
    QCOMPARE(ends.size(), 1U);
    QCOMPARE(ends[0].id, 5U);
    QCOMPARE(ends[0].outcome, drive::Outcome::NotSent);
}

void TestSession::armingIsToldAndEndsWithTheStop()
{
    Bench bench;
    bench.session.setArmed(true);
    QVERIFY(bench.armed.empty());
    bench.session.open(Bench::serial());
    bench.session.setArmed(true);
    bench.session.stop();
    QCOMPARE(bench.armed, (std::vector<bool>{true, false}));
}

void TestSession::aPortThatCannotBeOpenedIsToldOnce()
{
    Bench bench;
    bench.port.openResult = {PortProblem::Busy, QStringLiteral("other (pid 1)")};
    bench.session.open(Bench::serial());
    bench.runUntil(bench.now + 5s);
    QCOMPARE(bench.ports, (std::vector<Port>{{PortState::Closed, PortProblem::Busy}}));
    QCOMPARE(bench.board.made, 0);
}

void TestSession::closingWaitsForTheLastWordsButNotForLong()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.drive().farewell = bytes({9});
    const TimePoint start = bench.now;
    bench.session.close();
    QCOMPARE(bench.port.written.size(), 1U);
    QCOMPARE(bench.port.closed, 0);
    bench.runUntil(start + 299ms);
    QCOMPARE(bench.port.closed, 0);
    bench.runUntil(start + 300ms);
    QCOMPARE(bench.port.closed, 1);
    QCOMPARE(bench.ports.back(), Port(PortState::Closed, PortProblem::None));
}

void TestSession::closingEndsAtOnceWhenTheDriveIsSilent()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.session.close();
    QCOMPARE(bench.port.closed, 1);
    QCOMPARE(bench.told<drive::LinkChanged>().size(), 1U);
    QCOMPARE(bench.ports.size(), 2U);
}

void TestSession::openingAnOpenSessionClosesItFirst()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.session.open(Bench::serial());
    bench.runUntil(bench.now + 1s);
    QCOMPARE(bench.ports,
        (std::vector<Port>{{PortState::Open, PortProblem::None},
            {PortState::Closed, PortProblem::None}, {PortState::Open, PortProblem::None}}));
    QCOMPARE(bench.board.connects, 2);
}

void TestSession::anUnpluggedPortIsToldOnceAndTheDriveIsToldToo()
{
    Bench bench;
    session::Endpoint endpoint = Bench::serial();
    endpoint.reopen = false;
    bench.session.open(endpoint);
    bench.port.alive->fail();
    bench.runUntil(bench.now + 5s);
    QCOMPARE(bench.board.disconnects, 1);
    QCOMPARE(bench.port.opened, 1);
    QCOMPARE(bench.ports,
        (std::vector<Port>{
            {PortState::Open, PortProblem::None}, {PortState::Closed, PortProblem::Unplugged}}));
}

void TestSession::anUnpluggedPortIsTriedAgainEveryHalfSecond()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.session.setArmed(true);
    bench.port.alive->fail();
    bench.port.openResult = {PortProblem::NotFound, {}};
    bench.runUntil(bench.now + 1900ms);
    QCOMPARE(bench.ports.size(), 2U); // the attempts are not told
    bench.port.openResult = {};
    bench.runUntil(bench.now + 100ms);
    QCOMPARE(bench.ports.back(), Port(PortState::Open, PortProblem::None));
    QCOMPARE(bench.board.connects, 2);
    QVERIFY(!bench.drive().armed());
    QCOMPARE(bench.armed, (std::vector<bool>{true, false}));
}

void TestSession::reopeningTakesUpStreamingAndNothingElse()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.session.submit({.id = 1,
        .what = drive::Stream{.fast = {1, 2}, .fastEvery = 1, .slow = {}, .slowEvery = 1}});
    bench.session.submit(
        {.id = 2, .what = drive::SpeedRamp{.motor = 1, .rpm = 1000, .duration = 1s}});
    bench.session.submit(
        {.id = 3, .what = drive::Command{.action = drive::MotorAction::Start, .motor = 1}});
    bench.session.submit({.id = 4, .what = drive::Watch{.registers = {3}, .period = 100ms}});
    bench.board.wishes.clear();
    bench.port.alive->fail();
    bench.runUntil(bench.now + 600ms);
    QVERIFY(bench.board.wishes.empty());
    bench.drive().events.push_back(drive::Identified{});
    bench.turn();
    QCOMPARE(bench.board.wishes.size(), 2U);
    QVERIFY(std::holds_alternative<drive::Stream>(bench.board.wishes[0].what));
    QVERIFY(std::holds_alternative<drive::Watch>(bench.board.wishes[1].what));
    QCOMPARE(bench.board.wishes[0].id, 0U);
}

void TestSession::ownLimitsAreGivenToEveryDriveFirst()
{
    Bench bench;
    const drive::UserLimits limits{.maxSpeedRpm = 1000.0, .maxCurrentAmps = 2.0};
    bench.session.submit({.id = 1, .what = limits});
    bench.session.open(Bench::serial());
    for (int connection = 0; connection < 2; ++connection) {
        QCOMPARE(bench.board.wishes.size(), 1U);
        QVERIFY(std::get<drive::UserLimits>(bench.board.wishes.front().what) == limits);
        bench.board.wishes.clear();
        bench.port.alive->fail();
        bench.runUntil(bench.now + 600ms);
    }
}

void TestSession::closingEndsTheAttemptsToReopen()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.port.alive->fail();
    bench.session.close();
    bench.runUntil(bench.now + 5s);
    QCOMPARE(bench.port.opened, 1);
    QCOMPARE(bench.ports.back(), Port(PortState::Closed, PortProblem::None));
}

void TestSession::aStalledReceiverGetsNoThirdBatch()
{
    Bench bench;
    bench.acknowledging = false;
    bench.session.open(Bench::serial());
    for (int i = 0; i < 100; ++i) {
        bench.drive().events.push_back(drive::LinkCounters{});
        bench.runUntil(bench.now + 20ms);
    }
    QCOMPARE(bench.batches.size(), 2U);
    bench.session.acknowledge();
    QCOMPARE(bench.batches.size(), 3U);
    QCOMPARE(bench.batches.back()->events.size(), 1U);
}

void TestSession::theSessionCanBeClosedFromWithinABatch()
{
    Bench bench;
    bench.session.open(Bench::serial());
    QObject::connect(
        &bench.session, &session::Session::batch, &bench.session, &session::Session::close);
    bench.drive().events.push_back(drive::LinkCounters{});
    bench.turn();
    bench.runUntil(bench.now + 1s);
    QCOMPARE(bench.port.closed, 1);
    QCOMPARE(bench.ports.size(), 2U);
}

QTEST_GUILESS_MAIN(TestSession)
#include "tst_session.moc"
