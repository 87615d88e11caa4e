// The session's pump on virtual time: what goes to the port when, what comes back, and how a port
// ends.
#include "core/session/fakes.h"

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
    void theDrivesTimeNeverGoesBack();
    void bytesReachTheDriveAndItsEventsComeOut();
    void theDrivesTimeoutIsKept();
    void whileNothingMovesBytesMayComeTogether();
    void whileBytesComeTogetherWhatHasLeftIsToldWithThem();
    void aStopFromAnotherThreadReachesTheDriveBeforeQueuedWishes();
    void aStopThatComesDuringATurnIsBeforeWhatLeavesInIt();
    void aStopIsHandedOnBeforeTheBytesThatCameWithIt();
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
    void aStopThatIsNotConfirmedIsTheFirstActOnTheReopenedPort();
    void aConfirmedStopIsOver();
    void aStopWhileThePortIsGoneIsCarriedOutWhenItIsBack();
    void aStopIsTakenBackByAPersonOnly();
    void aBoardOnAnotherPortIsStoppedButConfirmsNothing();
    void aStopWhileClosingIsCarriedOut();
    void closingWaitsForAnOpenStop();
    void aStopBetweenTwoPortsIsForBoth();
    void aPortThatFailsWhileClosingMakesRoomForTheNext();
    void whatWaitsIsDroppedBeforeABlindStop();
    void whatIsDroppedWhileItIsWrittenTakesNoStopWithIt();
    void aPortThatIsLeftForgetsWhatCouldNotLeave();
    void whatIsKnownOfALineOutlivesItsPort();
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

/// A frame that leaves behind a pause would count as one from before it, and so would the samples that it brings.
void TestSession::theDrivesTimeNeverGoesBack()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.port.onAdvance = [&] {
        bench.now += 500ms; // nothing ran
        bench.port.alive->hear("ab");
    };
    bench.drive().outputs = {{bytes({1}), {}}};
    bench.board.calledAt.clear();
    bench.turn();
    QCOMPARE(bench.board.received.size(), 2U);
    QVERIFY(bench.board.calledAt.size() >= 2);
    for (const TimePoint at : bench.board.calledAt)
        QCOMPARE(at, bench.now);
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

void TestSession::whileNothingMovesBytesMayComeTogether()
{
    Bench bench;
    bench.session.open(Bench::serial());
    QCOMPARE(bench.port.gathers, Duration::zero());
    bench.drive().gathers = 10ms;
    bench.turn();
    QCOMPARE(bench.port.gathers, Duration(10ms));
    bench.drive().outputs = {{bytes({1, 2, 3, 4}), {}}, {bytes({5}), 1500us}};
    bench.turn();
    QCOMPARE(bench.port.gathers, Duration(10ms)); // also while a request is under way
    bench.session.setArmed(true);
    bench.session.submit({.id = 1, .what = drive::Command{drive::MotorAction::Start, 1}});
    QCOMPARE(bench.port.gathers, Duration::zero()); // it may turn, whatever the drive knows
}

void TestSession::whileBytesComeTogetherWhatHasLeftIsToldWithThem()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.drive().gathers = 10ms;
    bench.turn();
    const TimePoint start = bench.now;
    bench.drive().outputs = {{Bytes(100), {}}, {bytes({5}), 1500us}};
    bench.turn();
    QCOMPARE(*bench.session.nextStep(), start + 1ms + 1500us); // what is to leave does so in time
    bench.runUntil(start + 1ms + 1500us);
    QCOMPARE(bench.port.written.size(), 2U);
    QVERIFY(bench.board.sentAt.empty());
    QCOMPARE(*bench.session.nextStep(), start + 1ms + 1500us + 10us + 10ms);
    bench.now = start + 5ms;
    bench.port.alive->hear("ab");
    QCOMPARE(bench.board.sentAt, std::vector<TimePoint>{bench.now});

    bench.drive().events.push_back(drive::LinkCounters{});
    bench.turn();
    bench.drive().events.push_back(drive::LinkCounters{}); // behind a batch, the next has its time
    bench.turn();
    QCOMPARE(*bench.session.nextStep(), bench.now + 66ms + 10ms);
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

void TestSession::aStopThatComesDuringATurnIsBeforeWhatLeavesInIt()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.drive().outputs = {{bytes({1}), {}}};
    int stopsBeforeWriting = -1;
    bench.port.onWrite = [&] { stopsBeforeWriting = bench.board.stops; };
    // What the port does takes time, in which the user presses Esc.
    bench.port.onAdvance = [&] {
        if (bench.port.written.empty() && bench.board.stops == 0)
            bench.session.stopFromAnyThread();
    };
    bench.turn();
    QCOMPARE(stopsBeforeWriting, 1);
    QCOMPARE(bench.board.stops, 1);
}

/// What the drive asks next when it has heard them would leave before the STOP.
void TestSession::aStopIsHandedOnBeforeTheBytesThatCameWithIt()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.port.onAdvance = [&] {
        if (bench.board.stops == 0) {
            bench.session.stopFromAnyThread();
            bench.port.alive->hear(QByteArray("x"));
        }
    };
    bench.turn();
    QCOMPARE(bench.board.received, Bytes{std::uint8_t{'x'}});
    QCOMPARE(bench.board.stopsBeforeBytes, 1);
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

namespace {

/// Nothing is found at the port until it is plugged in again.
void unplug(Bench &bench)
{
    bench.port.openResult = {PortProblem::NotFound, {}};
    bench.port.alive->fail();
}

void plugIn(Bench &bench)
{
    bench.port.openResult = {};
    bench.runUntil(bench.now + 600ms);
}

const QStringList kBench{QStringLiteral("bench")};

} // namespace

void TestSession::aStopThatIsNotConfirmedIsTheFirstActOnTheReopenedPort()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.session.stop();
    bench.runUntil(bench.now + 150ms);
    QVERIFY(bench.wanted.empty()); // it is under way
    unplug(bench);
    QCOMPARE(bench.wanted, (std::vector<QStringList>{kBench})); // told at once
    bench.runUntil(bench.now + 60s);
    QCOMPARE(bench.board.stops, 1);
    for (int again = 2; again < 5; ++again) {
        bench.port.openResult = {};
        while (bench.board.made < again) {
            QVERIFY(bench.session.nextStep());
            bench.now = *bench.session.nextStep();
            bench.session.step(bench.now);
        }
        QCOMPARE(bench.board.stops, again); // in the turn that opened it
        QVERIFY(bench.wanted.back().isEmpty());
        unplug(bench);
        QCOMPARE(bench.wanted.back(), kBench);
    }
}

void TestSession::aConfirmedStopIsOver()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.session.stop();
    bench.drive().stopping = false;
    bench.turn();
    unplug(bench);
    plugIn(bench);
    QCOMPARE(bench.board.made, 2);
    QCOMPARE(bench.board.stops, 1);
    QVERIFY(bench.wanted.empty());
}

void TestSession::aStopWhileThePortIsGoneIsCarriedOutWhenItIsBack()
{
    Bench bench;
    bench.session.open(Bench::serial());
    unplug(bench);
    bench.runUntil(bench.now + 2s);
    bench.session.stop();
    QCOMPARE(bench.wanted, (std::vector<QStringList>{kBench}));
    plugIn(bench);
    QCOMPARE(bench.board.made, 2);
    QCOMPARE(bench.board.stops, 1);
    // And does not wait for the next attempt.
    bench.port.alive->fail();
    bench.session.stop();
    QCOMPARE(bench.board.made, 3);
    QCOMPARE(bench.board.stops, 2);
}

void TestSession::aStopIsTakenBackByAPersonOnly()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.session.stop();
    unplug(bench);
    bench.session.close();
    QCOMPARE(bench.wanted.back(), kBench);
    bench.port.openResult = {};
    bench.session.open(Bench::serial());
    QCOMPARE(bench.board.stops, 2);
    unplug(bench);
    bench.session.forgetStop();
    QVERIFY(bench.wanted.back().isEmpty());
    plugIn(bench);
    QCOMPARE(bench.board.made, 3);
    QCOMPARE(bench.board.stops, 2);
}

void TestSession::aBoardOnAnotherPortIsStoppedButConfirmsNothing()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.session.stop();
    unplug(bench);
    bench.port.openResult = {};
    bench.session.open(Bench::serial(QStringLiteral("other")));
    QCOMPARE(bench.board.stops, 2); // it may be the same board, with another number
    bench.drive().stopping = false;
    bench.turn();
    QCOMPARE(bench.wanted.back(), kBench);
    bench.session.open(Bench::serial());
    bench.runUntil(bench.now + 1s);
    QCOMPARE(bench.board.made, 3);
    QCOMPARE(bench.board.stops, 3);
    bench.drive().stopping = false;
    bench.turn();
    bench.session.close();
    bench.runUntil(bench.now + 1s);
    QVERIFY(bench.wanted.back().isEmpty());
}

void TestSession::aStopWhileClosingIsCarriedOut()
{
    for (const bool confirmed : {true, false}) {
        Bench bench;
        bench.session.open(Bench::serial());
        bench.drive().farewell = bytes({9});
        bench.session.close();
        bench.runUntil(bench.now + 100ms);
        bench.session.stop();
        const TimePoint asked = bench.now;
        QCOMPARE(bench.board.stops, 1);
        bench.runUntil(asked + 1900ms);
        QCOMPARE(bench.port.closed, 0);
        bench.drive().farewell.clear();
        bench.drive().stopping = !confirmed;
        bench.runUntil(confirmed ? asked + 1900ms : asked + 2s);
        QCOMPARE(bench.port.closed, 1);
        QCOMPARE(bench.ports.back(), Port(PortState::Closed, PortProblem::None));
        QCOMPARE(bench.wanted.size(), confirmed ? 0U : 1U); // told as not carried out
    }
}

void TestSession::closingWaitsForAnOpenStop()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.session.stop();
    bench.session.close();
    bench.runUntil(bench.now + 1s);
    QCOMPARE(bench.port.closed, 0);
    QCOMPARE(bench.board.disconnects, 0);
    bench.drive().stopping = false;
    bench.turn();
    QCOMPARE(bench.port.closed, 1);
    QVERIFY(bench.session.closed());
}

void TestSession::aStopBetweenTwoPortsIsForBoth()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.drive().farewell = bytes({9});
    bench.session.open(Bench::serial(QStringLiteral("other")));
    bench.session.stop();
    bench.drive().farewell.clear();
    bench.drive().stopping = false;
    bench.runUntil(bench.now + 10ms);
    QCOMPARE(bench.board.made, 2);
    QCOMPARE(bench.board.stops, 2);
}

void TestSession::aPortThatFailsWhileClosingMakesRoomForTheNext()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.drive().farewell = bytes({9});
    bench.session.open(Bench::serial(QStringLiteral("other")));
    bench.port.alive->fail();
    QCOMPARE(bench.board.made, 2);
    QCOMPARE(bench.ports.back(), Port(PortState::Open, PortProblem::None));
}

void TestSession::whatWaitsIsDroppedBeforeABlindStop()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.drive().outputs = {{bytes({1}), {}}, {bytes({2}), 1ms}}; // a start, say
    bench.port.sent = false; // on a line that takes nothing
    bench.runUntil(bench.now + 20ms);
    bench.drive().outputs = {{bytes({3}), 2ms, true}, {bytes({4}), 2ms}};
    bench.runUntil(bench.now + 20ms);
    QCOMPARE(bench.port.discarded, 1);
    std::vector<Bytes> written;
    for (const auto &one : bench.port.written)
        written.push_back(one.bytes);
    QCOMPARE(written, (std::vector<Bytes>{{1}, {3}, {4}})); // the port has thrown away the 1
}

/// A line that answers within write(), as SPI does, on a computer that slept just then.
void TestSession::whatIsDroppedWhileItIsWrittenTakesNoStopWithIt()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.drive().outputs = {{bytes({1}), {}}, {bytes({2}), {}}};
    bench.port.onWrite = [&] {
        if (std::exchange(bench.slept, 8h) != 0s)
            return;
        bench.session.stopFromAnyThread();
        bench.port.alive->hear(QByteArray("x"));
        bench.drive().outputs = {{bytes({0x5A}), {}}};
    };
    bench.turn();
    QCOMPARE(bench.board.stops, 1);
    bench.runUntil(bench.now + 20ms);
    std::vector<Bytes> written;
    for (const auto &one : bench.port.written)
        written.push_back(one.bytes);
    QCOMPARE(written, (std::vector<Bytes>{{1}, {0x5A}}));
}

void TestSession::aPortThatIsLeftForgetsWhatCouldNotLeave()
{
    for (const bool stopping : {false, true}) {
        Bench bench;
        bench.session.open(Bench::serial());
        bench.drive().outputs = {{bytes({1}), {}}};
        bench.port.sent = false;
        if (stopping)
            bench.session.stop();
        bench.session.close();
        bench.runUntil(bench.now + 3s);
        QCOMPARE(bench.port.closed, 1);
        QCOMPARE(bench.port.discarded, stopping ? 0 : 1); // a STOP may leave as late as it can
    }
}

void TestSession::whatIsKnownOfALineOutlivesItsPort()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.drive().known = {drive::Protocol::Fcp, 2, {{5, 0, 0, 0}}};
    bench.turn();
    unplug(bench);
    plugIn(bench);
    QCOMPARE(bench.drive().known.motors, 2);
    QVERIFY(bench.drive().known.agreed.has_value());
    bench.session.open(Bench::serial(QStringLiteral("other")));
    bench.runUntil(bench.now + 1s);
    QCOMPARE(bench.drive().known.motors, 1);
    QCOMPARE(bench.board.madeFor,
        (std::vector<std::optional<drive::Protocol>>{
            std::nullopt, drive::Protocol::Fcp, std::nullopt}));
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
