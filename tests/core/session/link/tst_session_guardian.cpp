// What a session tells its guardian, and when; and what it does when the guardian has acted. On virtual time, with a
// guardian that only notes.
#include "core/session/fakes.h"

#include <QTest>

using namespace std::chrono_literals;
using fakes::Bench;
using fakes::bytes;
using session::Guardian;
using session::PortProblem;
using session::PortState;

class TestSessionGuardian : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itKnowsBeforeAnythingLeavesThatMoves();
    void nobodyIsGuardedWhoMovedNothing();
    void restEndsItAndNothingElse();
    void everyMotorHasToRest();
    void whoClosesHasDecided();
    void aLostPortChangesNothing();
    void aQuietSessionStampsAllTheSame();
    void whenItActedNothingIsSentAnyMore();
    void aGuardianThatDiedWhileItSentIsNotWaitedForForEver();
};

namespace {

struct NotedGuardian : Guardian {
    int port = -2;
    bool driven = false;
    int stamps = 0;
    Act acted = Act::None;
    std::vector<Output> script;
    std::vector<bool> changes;
    void watch(int) override
    {
        port = 1;
        acted = Act::None;
    }
    void letGo() override { port = -1; }
    void setScript(const std::vector<Output> &next, std::uint32_t) override { script = next; }
    void setDriven(bool on) override
    {
        if (std::exchange(driven, on) != on)
            changes.push_back(on);
        stamp();
    }
    void stamp() override { ++stamps; }
    Act act() const override { return acted; }
};

drive::MotorStatus statusOf(drive::MotorState state, TimePoint at, int motor = 1)
{
    drive::MotorStatus status;
    status.motor = motor;
    status.state = state;
    status.at = at;
    return status;
}

struct Guarded {
    std::shared_ptr<NotedGuardian> notes = std::make_shared<NotedGuardian>();
    Bench bench{session::Attendance::OwnThread, notes};

    Guarded()
    {
        bench.session.open(Bench::serial());
        bench.session.setArmed(true);
    }
    void start()
    {
        bench.session.submit({.id = 7, .what = drive::Command{}});
        bench.drive().events.push_back(
            drive::Ended{.id = 7, .outcome = drive::Outcome::Ok, .reason = {}, .writes = {}});
        bench.turn();
    }
    void tell(drive::MotorState state, int motor = 1)
    {
        bench.drive().events.push_back(statusOf(state, bench.now, motor));
        bench.turn();
    }
};

} // namespace

void TestSessionGuardian::itKnowsBeforeAnythingLeavesThatMoves()
{
    for (const decltype(drive::Wish::what) &what : {decltype(drive::Wish::what)(drive::Command{}),
             decltype(drive::Wish::what)(drive::SpeedRamp{}),
             decltype(drive::Wish::what)(drive::TorqueRamp{}),
             decltype(drive::Wish::what)(drive::CurrentReference{}),
             decltype(drive::Wish::what)(drive::PositionRamp{}),
             decltype(drive::Wish::what)(drive::CyclicSetPoints{}),
             decltype(drive::Wish::what)(drive::Write{})}) {
        Guarded guarded;
        QCOMPARE(guarded.notes->port, 1);
        guarded.bench.drive().outputs.push_back({bytes({1}), {}});
        bool knew = false;
        QVERIFY(!guarded.notes->driven);
        guarded.bench.port.onWrite = [&] {
            knew = guarded.notes->driven && !guarded.notes->script.empty();
        };
        guarded.bench.session.submit({.id = 7, .what = what});
        QVERIFY(!guarded.bench.port.written.empty());
        QVERIFY(knew);
        QCOMPARE(guarded.notes->script.front().bytes, bytes({0x5A}));
    }
}

void TestSessionGuardian::nobodyIsGuardedWhoMovedNothing()
{
    Guarded guarded;
    guarded.bench.session.submit({.id = 1, .what = drive::Read{{1}}});
    guarded.bench.session.submit({.id = 2, .what = drive::Stream{}});
    guarded.tell(drive::MotorState::Running); // by any start
    QVERIFY(guarded.notes->changes.empty());
    guarded.bench.session.setArmed(false);
    guarded.bench.session.submit({.id = 3, .what = drive::Command{}});
    QVERIFY(guarded.notes->changes.empty());
}

void TestSessionGuardian::restEndsItAndNothingElse()
{
    using drive::MotorState;
    Guarded guarded;
    guarded.start();
    QVERIFY(guarded.notes->driven);
    guarded.tell(MotorState::Idle); // asked before the start
    guarded.tell(MotorState::Idle);
    QVERIFY(guarded.notes->driven);
    guarded.bench.now += 400ms;
    guarded.tell(MotorState::Running);
    guarded.tell(MotorState::Idle);
    guarded.tell(MotorState::Unknown);
    guarded.tell(MotorState::Idle);
    guarded.bench.session.stop();
    guarded.bench.session.setArmed(false);
    guarded.bench.turn();
    QVERIFY(guarded.notes->driven); // a stop that was sent is no rest
    guarded.tell(MotorState::Idle);
    QVERIFY(!guarded.notes->driven);
}

void TestSessionGuardian::everyMotorHasToRest()
{
    using drive::MotorState;
    Guarded guarded;
    drive::Identified board{};
    board.identity.motors = 2;
    guarded.bench.drive().events.push_back(board);
    guarded.start();
    guarded.bench.now += 400ms;
    for (int i = 0; i < 3; ++i)
        guarded.tell(MotorState::Idle, 1);
    QVERIFY(guarded.notes->driven);
    guarded.tell(MotorState::Idle, 2);
    guarded.tell(MotorState::Idle, 2);
    QVERIFY(!guarded.notes->driven);
}

void TestSessionGuardian::whoClosesHasDecided()
{
    Guarded guarded;
    guarded.start();
    guarded.bench.session.close();
    QVERIFY(!guarded.notes->driven);
    QCOMPARE(guarded.notes->port, -1);
}

void TestSessionGuardian::aLostPortChangesNothing()
{
    Guarded guarded;
    guarded.start();
    guarded.bench.port.alive->fail();
    QCOMPARE(guarded.notes->port, -1);
    guarded.bench.runUntil(guarded.bench.now + 600ms);
    QCOMPARE(guarded.notes->port, 1);
    QVERIFY(guarded.notes->driven);
}

void TestSessionGuardian::aQuietSessionStampsAllTheSame()
{
    Guarded guarded;
    guarded.start();
    guarded.bench.runUntil(guarded.bench.now + 100ms);
    for (int i = 0; i < 6; ++i) {
        const int before = guarded.notes->stamps;
        guarded.bench.runUntil(guarded.bench.now + Guardian::kStampEvery);
        QVERIFY(guarded.notes->stamps > before);
    }
}

void TestSessionGuardian::whenItActedNothingIsSentAnyMore()
{
    Guarded guarded;
    Bench &bench = guarded.bench;
    guarded.start();
    bench.port.written.clear();
    bench.drive().outputs.push_back({bytes({1}), {}}); // a start of before
    bench.now += 5s; // frozen
    guarded.notes->acted = Guardian::Act::Stopping;
    bench.session.submit({.id = 8, .what = drive::Command{}});
    bench.runUntil(bench.now + 1s);
    QVERIFY(bench.port.written.empty());
    QCOMPARE(bench.port.closed, 0); // the line is the guardian's
    guarded.notes->acted = Guardian::Act::Stopped;
    bench.runUntil(bench.now + 200ms);
    QVERIFY(bench.port.written.empty());
    QCOMPARE(bench.ports.back(), std::pair(PortState::Closed, PortProblem::TakenOver));
    QCOMPARE(bench.armed.back(), false);
    bench.runUntil(bench.now + 600ms);
    QCOMPARE(bench.ports.back(), std::pair(PortState::Open, PortProblem::None));
    QCOMPARE(bench.board.made, 2);
    QVERIFY(!bench.drive().armed());
    QVERIFY(guarded.notes->driven); // it was not seen at rest
}

void TestSessionGuardian::aGuardianThatDiedWhileItSentIsNotWaitedForForEver()
{
    Guarded guarded;
    Bench &bench = guarded.bench;
    guarded.start();
    guarded.notes->acted = Guardian::Act::Stopping;
    bench.runUntil(bench.now + 10s);
    QVERIFY(bench.ports.size() >= 3);
    QCOMPARE(bench.ports.at(1), std::pair(PortState::Closed, PortProblem::TakenOver));
}

QTEST_GUILESS_MAIN(TestSessionGuardian)
#include "tst_session_guardian.moc"
