// DeadMan and Stamps by themselves: what is judged when, and when the next look is due. No session, no thread; times
// are numbers. What a session makes of it is in tst_dead_man.
#include "session/link/dead_man.h"
#include "session/link/time_gap.h"

#include <QTest>

using namespace session;
using namespace std::chrono_literals;
using drive::MotorState;
using Cause = Interruption::Cause;
using News = std::vector<Interruption>;
using Wait = std::optional<Duration>;

namespace {

constexpr TimePoint t{100s};

drive::MotorStatus stateOf(MotorState state, int motor = 1)
{
    drive::MotorStatus status;
    status.motor = motor;
    status.state = state;
    return status;
}

/// A connection that was opened, and armed, at `t`.
struct DeadManBench {
    explicit DeadManBench(Attendance attendance = Attendance::Stamped, bool armed = true)
        : man(attendance)
        , isArmed(armed)
    {
        man.begin(t);
        if (armed)
            man.armed();
        man.acceptStatus(stateOf(MotorState::Running));
    }
    DeadMan::Verdict at(Duration time, Duration gap = {})
    {
        const DeadMan::Verdict verdict = man.judge(stamps.take(), isArmed, gap, t + time);
        isArmed = isArmed && !verdict.disarm;
        return verdict;
    }
    void attend(Duration time) { stamps.attend(t + time); }

    Stamps stamps;
    DeadMan man;
    bool isArmed;
};

} // namespace

class TestDeadManRules : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void stampsTellTheLongestSilence();
    void aHoldHasANumberAndAMotor();
    void absenceBeginsBehindItsLimit();
    void whoIsGoneIsStoppedForOnce();
    void aStopForAnotherReasonIsToldWithIt();
    void whatNobodyHereAnswersForIsNotStopped_data();
    void whatNobodyHereAnswersForIsNotStopped();
    void aSilenceThatIsOverCountsAllTheSame();
    void aGapIsToldOnce();
    void aGapUnderOneThreadIsTheAbsence();
    void aConnectionBeginsAnew();
    void restEndsTheResponsibility();
    void aHoldEndsByItself();
    void anEndedHoldNeedsItsIdleMotor();
    void theNextLook();
    void theNextLookAtAHold();
    void aTimeGap();
};

void TestDeadManRules::stampsTellTheLongestSilence()
{
    Stamps stamps;
    Stamps::Seen seen = stamps.take();
    QVERIFY(!seen.attended && seen.motor == 0 && seen.hold == 0);
    stamps.attend(t);
    seen = stamps.take();
    QVERIFY(seen.attended == t && seen.longestSilence == 0ms); // the first has nothing before it
    for (const Duration time : {300ms, 350ms, 600ms, 610ms})
        stamps.attend(t + time);
    seen = stamps.take();
    QVERIFY(seen.attended == t + 610ms && seen.longestSilence == 300ms);
    QVERIFY(stamps.take().longestSilence == 0ms);
}

void TestDeadManRules::aHoldHasANumberAndAMotor()
{
    Stamps stamps;
    stamps.hold(0, t); // there is none
    QVERIFY(stamps.take().hold == 0);
    stamps.hold(3, t);
    const Stamps::Seen first = stamps.take();
    QVERIFY(first.motor == 3 && first.hold != 0 && first.held == t);
    stamps.hold(3, t + 50ms);
    QVERIFY(stamps.take().hold == first.hold && stamps.take().held == t + 50ms);
    stamps.release();
    QVERIFY(stamps.take().hold == 0 && stamps.take().motor == 0);
    stamps.hold(1, t + 60ms);
    const Stamps::Seen second = stamps.take();
    QVERIFY(second.hold != first.hold && second.hold != 0 && second.motor == 1);
}

void TestDeadManRules::absenceBeginsBehindItsLimit()
{
    DeadManBench bench;
    bench.attend(0ms);
    QVERIFY(!bench.at(500ms).disarm && !bench.man.absent());
    const DeadMan::Verdict verdict = bench.at(500ms + 1ns);
    QVERIFY(verdict.disarm && !verdict.stopAll && verdict.stopMotor == 0);
    QVERIFY(bench.man.absent());
    QVERIFY(!bench.at(600ms).disarm); // it is not armed any more
    QVERIFY(bench.man.takeNews().empty()); // the user is away
    bench.attend(700ms);
    static_cast<void>(bench.at(1200ms));
    QVERIFY((bench.man.takeNews() == News{{Cause::Interface, 700ms, true, false}}));
    QVERIFY(!bench.man.absent());
}

void TestDeadManRules::whoIsGoneIsStoppedForOnce()
{
    DeadManBench bench;
    bench.attend(0ms);
    QVERIFY(!bench.at(2s).stopAll);
    QVERIFY(bench.at(2s + 1ns).stopAll);
    QVERIFY(!bench.at(3s).stopAll); // the stop goes on by itself
    bench.attend(5s);
    static_cast<void>(bench.at(5s + 500ms + 1ns)); // not back: that stamp is too old
    QVERIFY(bench.man.absent());
    bench.attend(6s);
    static_cast<void>(bench.at(6s));
    QVERIFY((bench.man.takeNews() == News{{Cause::Interface, 5s, true, true}}));
    QVERIFY(bench.man.takeNews().empty());
    QVERIFY(bench.at(8s + 1ns).stopAll); // the next absence
}

/// As that of an experiment, which the disarming ends. "The motors go on as they are" would not be so.
void TestDeadManRules::aStopForAnotherReasonIsToldWithIt()
{
    DeadManBench bench;
    bench.attend(0ms);
    QVERIFY(bench.at(600ms).disarm);
    bench.man.stopped();
    QVERIFY(!bench.at(3s).stopAll); // that one goes on by itself
    bench.attend(4s);
    static_cast<void>(bench.at(4s));
    QVERIFY((bench.man.takeNews() == News{{Cause::Interface, 4s, true, true}}));
    DeadManBench slept;
    slept.attend(0ms);
    static_cast<void>(slept.at(20ms, 3s)); // is told in the turn in which it is seen
    slept.man.stopped();
    QVERIFY((slept.man.takeNews() == News{{Cause::Gap, 3s, true, true}}));
}

void TestDeadManRules::whatNobodyHereAnswersForIsNotStopped_data()
{
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("second");
    QTest::addColumn<bool>("armedOnce");
    QTest::addColumn<bool>("stops");
    const auto row = [](const char *name, MotorState first, MotorState second, bool armedOnce,
                         bool stops) {
        QTest::newRow(name) << static_cast<int>(first) << static_cast<int>(second) << armedOnce
                            << stops;
    };
    row("never armed", MotorState::Running, MotorState::Idle, false, false);
    row("idle", MotorState::Idle, MotorState::Idle, true, false);
    row("fault", MotorState::FaultNow, MotorState::FaultOver, true, false);
    row("runs", MotorState::Running, MotorState::Idle, true, true);
    row("the second runs", MotorState::Idle, MotorState::Running, true, true);
    row("starts", MotorState::Starting, MotorState::Idle, true, true);
    row("unknown", MotorState::Unknown, MotorState::Idle, true, true);
}

void TestDeadManRules::whatNobodyHereAnswersForIsNotStopped()
{
    QFETCH(const int, first);
    QFETCH(const int, second);
    QFETCH(const bool, armedOnce);
    QFETCH(const bool, stops);
    DeadManBench bench(Attendance::Stamped, armedOnce);
    bench.man.acceptStatus(stateOf(static_cast<MotorState>(first), 1));
    bench.man.acceptStatus(stateOf(static_cast<MotorState>(second), 2));
    QCOMPARE(bench.at(3s).stopAll, stops);
    bench.attend(4s);
    static_cast<void>(bench.at(4s));
    QCOMPARE(bench.man.takeNews().empty(), !armedOnce); // nothing was changed
    DeadManBench left; // the user has disarmed it, and lets it turn
    left.man.disarmed();
    left.isArmed = false;
    QVERIFY(!left.man.responsible() && !left.at(3s).stopAll);
    DeadMan unheard(Attendance::Stamped); // of a motor of which nothing is known
    unheard.begin(t);
    unheard.armed();
    QVERIFY(unheard.judge({}, true, {}, t + 3s).stopAll);
}

void TestDeadManRules::aSilenceThatIsOverCountsAllTheSame()
{
    DeadManBench bench;
    bench.attend(0ms);
    bench.attend(2001ms); // both stood still, and the interface woke first
    const DeadMan::Verdict verdict = bench.at(2001ms);
    QVERIFY(verdict.disarm && verdict.stopAll);
    QVERIFY((bench.man.takeNews() == News{{Cause::Interface, 2001ms, true, true}}));
    QVERIFY(!bench.man.absent());
}

void TestDeadManRules::aGapIsToldOnce()
{
    DeadManBench bench;
    bench.attend(0ms);
    static_cast<void>(bench.at(10ms));
    QVERIFY(bench.man.takeNews().empty()); // no gap
    static_cast<void>(bench.at(20ms, 3s)); // the interface was alive
    QVERIFY((bench.man.takeNews() == News{{Cause::Gap, 3s, true, false}}));
    bench.isArmed = false; // disarmed by it: what turns is still its own
    static_cast<void>(bench.at(30ms, 3s));
    QVERIFY((bench.man.takeNews() == News{{Cause::Gap, 3s, false, false}}));
    bench.man.disarmed();
    static_cast<void>(bench.at(40ms, 3s));
    QVERIFY(bench.man.takeNews().empty());
    bench.man.armed();
    bench.isArmed = true;
    static_cast<void>(bench.at(900ms, 800ms)); // both in one
    bench.attend(900ms);
    static_cast<void>(bench.at(900ms));
    QVERIFY((bench.man.takeNews() == News{{Cause::Gap, 900ms, true, false}}));
}

void TestDeadManRules::aGapUnderOneThreadIsTheAbsence()
{
    DeadManBench bench(Attendance::OwnThread);
    QVERIFY(!bench.at(1h).disarm);
    QVERIFY(!bench.at(1h, 500ms).disarm);
    QVERIFY((bench.man.takeNews() == News{{Cause::Gap, 500ms, true, false}}));
    const DeadMan::Verdict verdict = bench.at(2h, 2001ms);
    QVERIFY(verdict.disarm && verdict.stopAll && !bench.man.absent());
    QVERIFY((bench.man.takeNews() == News{{Cause::Gap, 2001ms, true, true}}));
    QVERIFY(!bench.man.nextLook(true, t));
}

void TestDeadManRules::aConnectionBeginsAnew()
{
    DeadManBench bench;
    bench.attend(0ms);
    bench.stamps.hold(1, t);
    static_cast<void>(bench.at(301ms)); // a hold that ended
    static_cast<void>(bench.at(700ms)); // and an absence
    bench.man.acceptStatus(stateOf(MotorState::Idle)); // and a motor at rest
    bench.man.begin(t + 10s);
    QVERIFY(!bench.man.responsible() && !bench.man.absent());
    bench.stamps.release();
    static_cast<void>(bench.man.takeNews());
    QVERIFY(!bench.at(10s + 500ms).stopAll); // stamps of before count from its beginning
    QVERIFY(!bench.man.absent());
    QVERIFY(bench.man.takeNews().empty());
    bench.man.armed();
    QVERIFY(bench.at(12s + 1ns).stopAll); // nothing is known of its motors yet
}

void TestDeadManRules::restEndsTheResponsibility()
{
    DeadManBench bench;
    bench.man.acceptStatus(stateOf(MotorState::Idle));
    static_cast<void>(bench.at(1ms));
    QVERIFY(bench.man.responsible()); // armed
    bench.isArmed = false;
    bench.man.acceptStatus(stateOf(MotorState::Running));
    static_cast<void>(bench.at(2ms));
    QVERIFY(bench.man.responsible()); // turns
    bench.man.acceptStatus(stateOf(MotorState::Idle));
    static_cast<void>(bench.at(3ms));
    QVERIFY(!bench.man.responsible());
}

void TestDeadManRules::aHoldEndsByItself()
{
    DeadManBench bench;
    bench.stamps.hold(2, t);
    bench.attend(300ms);
    QCOMPARE(bench.at(300ms).stopMotor, 0);
    const DeadMan::Verdict verdict = bench.at(300ms + 1ns);
    QVERIFY(verdict.stopMotor == 2 && !verdict.stopAll && !verdict.disarm);
    QVERIFY((bench.man.takeNews() == News{{Cause::Hold, 300ms + 1ns, false, true}}));
    bench.stamps.hold(2, t + 400ms);
    QCOMPARE(bench.at(400ms).stopMotor, 0);
    QVERIFY(!bench.at(701ms).stopMotor); // a stamp that comes late revives nothing
    QVERIFY(bench.man.takeNews().empty());
    bench.stamps.release();
    static_cast<void>(bench.at(702ms));
    bench.stamps.hold(2, t + 710ms); // a new one
    bench.attend(1000ms);
    QCOMPARE(bench.at(1010ms).stopMotor, 0);
    QCOMPARE(bench.at(1011ms).stopMotor, 2);
}

void TestDeadManRules::anEndedHoldNeedsItsIdleMotor()
{
    for (const MotorState state : {MotorState::Running, MotorState::Idle, MotorState::FaultNow,
             MotorState::FaultOver, MotorState::Unknown}) {
        DeadManBench bench;
        bench.stamps.hold(2, t);
        const Duration ended = 310ms;
        bench.attend(ended);
        QCOMPARE(bench.at(ended).stopMotor, 2);
        bench.man.acceptStatus(stateOf(state, 2));
        bench.attend(ended + 799ms);
        QVERIFY(!bench.at(ended + 799ms).stopAll);
        const bool idle = state != MotorState::Running && state != MotorState::Unknown;
        QCOMPARE(bench.at(ended + 800ms).stopAll, !idle);
        QVERIFY(!bench.at(ended + 801ms).stopAll); // once
    }
    DeadManBench silent; // nothing was heard of it
    silent.stamps.hold(2, t);
    static_cast<void>(silent.at(310ms));
    silent.attend(1110ms);
    QVERIFY(silent.at(1110ms).stopAll);
    DeadManBench gone; // what another rule stops stays stopped
    gone.man.acceptStatus(stateOf(MotorState::Idle, 2));
    gone.attend(0ms);
    gone.stamps.hold(2, t + 1300ms);
    static_cast<void>(gone.at(1601ms));
    QVERIFY(gone.at(2401ms).stopAll);
}

void TestDeadManRules::theNextLook()
{
    DeadManBench bench;
    bench.attend(0ms);
    static_cast<void>(bench.at(0ms));
    QVERIFY(bench.man.nextLook(true, t) == Wait(100ms));
    QVERIFY(bench.man.nextLook(true, t + 450ms) == Wait(50ms + 1ns)); // what is longer is late
    QVERIFY(bench.man.nextLook(true, t + 600ms) == Wait(1ns)); // never nothing at all
    static_cast<void>(bench.at(501ms));
    QVERIFY(bench.man.nextLook(false, t + 501ms) == Wait(100ms)); // it is to be told
    QVERIFY(bench.man.nextLook(false, t + 1950ms) == Wait(50ms + 1ns));
    QVERIFY(bench.man.nextLook(false, t + 2s) == Wait(1ns));
    QVERIFY(bench.man.nextLook(false, t + 2s + 1ns) == Wait(100ms)); // it was judged
    static_cast<void>(bench.at(2001ms));
    QVERIFY(bench.man.nextLook(false, t + 1950ms) == Wait(100ms)); // stopped already

    DeadManBench quiet(Attendance::Stamped, false);
    static_cast<void>(quiet.at(0ms));
    QVERIFY(!quiet.man.nextLook(false, t));
    QVERIFY(quiet.man.nextLook(true, t) == Wait(100ms));
    static_cast<void>(quiet.at(3s));
    QVERIFY(quiet.man.absent() && !quiet.man.nextLook(false, t + 3s)); // nothing to tell
    quiet.man.armed();
    QVERIFY(quiet.man.nextLook(false, t + 3s) == Wait(100ms));

    DeadManBench left; // disarmed by the absence, at rest since: only its word is open
    static_cast<void>(left.at(501ms));
    left.man.acceptStatus(stateOf(MotorState::Idle));
    static_cast<void>(left.at(502ms));
    QVERIFY(!left.man.responsible() && left.man.nextLook(false, t + 502ms) == Wait(100ms));
}

void TestDeadManRules::theNextLookAtAHold()
{
    DeadManBench bench(Attendance::OwnThread);
    bench.stamps.hold(1, t);
    static_cast<void>(bench.at(0ms));
    QVERIFY(bench.man.nextLook(true, t + 100ms) == Wait(200ms + 1ns));
    static_cast<void>(bench.at(301ms));
    QVERIFY(bench.man.nextLook(true, t + 301ms) == Wait(800ms)); // until it has to be idle
    bench.stamps.release();
    bench.stamps.hold(1, t + 400ms);
    static_cast<void>(bench.at(400ms));
    QVERIFY(bench.man.nextLook(true, t + 400ms) == Wait(300ms + 1ns)); // the sooner one
    bench.stamps.release();
    static_cast<void>(bench.at(1101ms));
    QVERIFY(!bench.man.nextLook(true, t + 1101ms));
}

void TestDeadManRules::aTimeGap()
{
    TimeGap gap;
    QVERIFY(gap.notice(t, t + 5h, {}) == 0ms); // the first: nothing to compare with
    QVERIFY(gap.notice(t + 10s, t + 5h + 10s, {}) == 0ms); // no wake-up was due
    QVERIFY(gap.notice(t + 20s, t + 5h + 20s, t + 19s) == 0ms); // late, but not longer than that
    QVERIFY(gap.notice(t + 30s, t + 5h + 30s, t + 29s - 1ns) == 1s + 1ns);
    QVERIFY(gap.notice(t + 40s, t + 5h + 41s, {}) == 0ms);
    QVERIFY(gap.notice(t + 50s, t + 5h + 52s + 1ns, {}) == 1s + 1ns); // it slept
    QVERIFY(gap.notice(t + 60s, t + 6h + 2s + 1ns, t + 57s) == 1h - 60s + 0s); // the longer one
    QVERIFY(gap.notice(t + 70s, t + 6h + 12s + 1ns, t + 80s) == 0ms); // woken early
}

QTEST_APPLESS_MAIN(TestDeadManRules)
#include "tst_dead_man_rules.moc"
