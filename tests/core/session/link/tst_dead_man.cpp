// The interface of a session that stands still, comes late or lets go without a word, and gaps in time; all
// on virtual time, but for the thread that is really kept from running.
#include "core/session/fakes.h"

#include "session/link/session_thread.h"

#include <QtTest>

#include <atomic>

using namespace fakes;
using drive::MotorState;
using session::Attendance;
using session::DeadMan;
using session::Interruption;
using Cause = session::Interruption::Cause;

namespace {

drive::MotorStatus status(MotorState state, int motor = 1)
{
    drive::MotorStatus status;
    status.motor = motor;
    status.state = state;
    return status;
}

/// A session whose interface stamps it, until it does not.
struct Attended : Bench {
    explicit Attended(MotorState state = MotorState::Running, bool arm = true)
        : Bench(Attendance::Stamped)
    {
        session.open(serial());
        tell(state);
        session.attendFromAnyThread();
        if (arm)
            session.setArmed(true);
    }
    void tell(MotorState state, int motor = 1)
    {
        drive().events.push_back(status(state, motor));
        turn();
    }
    /// The interface lives for so long; the board is heard meanwhile.
    void live(Duration time)
    {
        for (const TimePoint end = now + time; now < end;) {
            session.attendFromAnyThread();
            runUntil(std::min(end, now + 100ms));
        }
        session.attendFromAnyThread();
        turn();
    }
    void freeze(Duration time) { runUntil(now + time); }
    int motorStops() const
    {
        return static_cast<int>(
            std::count_if(board.wishes.begin(), board.wishes.end(), [](const drive::Wish &wish) {
                const auto *command = std::get_if<drive::Command>(&wish.what);
                return command != nullptr && command->action == drive::MotorAction::StopMotor;
            }));
    }
};

/// Real time and a real thread, with a motor that runs.
struct Threaded {
    struct CountingDrive : FakeDrive {
        CountingDrive(FakeDrive::Log &log, std::atomic<int> &count)
            : FakeDrive(log)
            , counted(count)
        {
            events.push_back(status(MotorState::Running));
        }
        void stop(TimePoint now) override
        {
            FakeDrive::stop(now);
            ++counted;
        }
        std::atomic<int> &counted;
    };

    FakeTransport::Log port;
    FakeDrive::Log board;
    std::atomic<int> stops = 0;
    session::SessionThread thread{parts()};

    session::Parts parts()
    {
        session::Parts parts = session::realParts();
        parts.transport = [this](const session::Endpoint &) {
            return std::make_unique<FakeTransport>(port);
        };
        parts.drive = [this](const session::Endpoint &) {
            return std::make_unique<CountingDrive>(board, stops);
        };
        return parts;
    }
    template <class What>
    void ask(What what)
    {
        // An order that a sanitizer sees, beside the lock of Qt that it does not.
        std::atomic<bool> over{false};
        const auto call = [&] {
            what();
            over = true;
        };
        QMetaObject::invokeMethod(thread.session(), call, Qt::BlockingQueuedConnection);
        QVERIFY(over);
    }
    void arm()
    {
        ask([this] { thread.session()->open(Bench::serial()); });
        thread.session()->attendFromAnyThread();
        ask([this] { thread.session()->setArmed(true); });
    }
    bool armed()
    {
        bool is = false;
        ask([&] { is = board.alive->armed(); });
        return is;
    }
    int doubts()
    {
        int are = 0;
        ask([&] { are = board.doubts; });
        return are;
    }
};

} // namespace

class TestDeadMan : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aLiveInterfaceKeepsWhatItHas();
    void afterHalfASecondItIsDisarmed();
    void afterTwoSecondsWhatItDrivesIsStoppedOnce();
    void anIdleMotorIsNotStopped();
    void whatWasLeftRunningIsNotStopped();
    void whatSomebodyElseStartedIsNotStopped();
    void aLostLinkIsNoLeavingRunning();
    void theFirstStampAfterwardsArmsNothing();
    void anInterfaceThatNeverStampsCannotArm();
    void armingThatComesLateIsNotDone();
    void anInterfaceInTheSessionsThreadIsThere();
    void eachConnectionBeginsAnew();

    void aSleepDisarmsAndDoubts();
    void aLateWakeDisarmsAndDoubts();
    void whatWaitedToLeaveDoesNotLeaveBehindAGap_data();
    void whatWaitedToLeaveDoesNotLeaveBehindAGap();
    void wakesOfEveryLatenessAreJudgedRightly();
    void whatWasQueuedDuringAGapComesAfterIt();
    void aStandstillOfBothStopsWhateverWakesFirst();
    void aStandstillOfAProgramWithOneThreadStopsToo();
    void whatIsNotArmedIsOnlyDoubted();

    void aHoldWithItsStampsGoesOn();
    void aHoldThatIsNotHeardOfStopsItsMotor();
    void whatDoesNotStopThenIsStoppedForGood();
    void aHoldThatEndedIsNotRevived();
    void theHeartOfTheInterfaceHoldsNothing();

    void askedToEndItStopsWhatItDrives();
    void askedToEndItLeavesWhatIsNotItsOwn();

    void aFrozenInterfaceIsSeenByTheRunningThread();
    void aStarvedSessionDisarmsWhenItRunsAgain();
};

void TestDeadMan::aLiveInterfaceKeepsWhatItHas()
{
    Attended bench;
    bench.live(1min);
    QVERIFY(bench.drive().armed());
    for (int i = 0; i < 100; ++i) { // up to the limit, again and again
        bench.freeze(DeadMan::kAbsentAfter);
        bench.session.attendFromAnyThread();
        bench.turn();
    }
    QVERIFY(bench.drive().armed());
    QCOMPARE(bench.board.stops, 0);
    QVERIFY(bench.interruptions.empty());
}

void TestDeadMan::afterHalfASecondItIsDisarmed()
{
    Attended bench;
    bench.live(1s);
    bench.freeze(DeadMan::kAbsentAfter);
    QVERIFY(bench.drive().armed());
    bench.freeze(1ms);
    QVERIFY(!bench.drive().armed());
    QCOMPARE(bench.armed, (std::vector<bool>{true, false}));
    QVERIFY(bench.interruptions.empty()); // the user is away
    bench.live(200ms);
    QCOMPARE(bench.interruptions.size(), 1U);
    QVERIFY(bench.interruptions[0].cause == Cause::Interface);
    QVERIFY(bench.interruptions[0].disarmed && !bench.interruptions[0].stopped);
    QVERIFY(bench.interruptions[0].length >= 500ms && bench.interruptions[0].length < 700ms);
    QCOMPARE(bench.board.stops, 0);
}

void TestDeadMan::afterTwoSecondsWhatItDrivesIsStoppedOnce()
{
    Attended bench;
    bench.live(1s);
    bench.freeze(DeadMan::kGoneAfter);
    QCOMPARE(bench.board.stops, 0);
    bench.freeze(1ms);
    QCOMPARE(bench.board.stops, 1);
    bench.freeze(20s);
    QCOMPARE(bench.board.stops, 1); // the drive keeps at it by itself
    bench.live(1s);
    QCOMPARE(bench.interruptions.size(), 1U);
    QVERIFY(bench.interruptions[0].disarmed && bench.interruptions[0].stopped);
    QVERIFY(bench.interruptions[0].length > 21s);
}

void TestDeadMan::anIdleMotorIsNotStopped()
{
    for (const MotorState state : {MotorState::Idle, MotorState::FaultNow, MotorState::FaultOver}) {
        Attended bench(state);
        bench.freeze(10s);
        QVERIFY(!bench.drive().armed());
        QCOMPARE(bench.board.stops, 0);
    }
    for (const MotorState state :
        {MotorState::Unknown, MotorState::Starting, MotorState::Running, MotorState::Stopping}) {
        Attended bench(state);
        bench.freeze(10s);
        QCOMPARE(bench.board.stops, 1);
    }
    Attended second(MotorState::Idle);
    second.tell(MotorState::Running, 2);
    second.freeze(10s);
    QCOMPARE(second.board.stops, 1);
    Attended late(MotorState::Idle); // it only starts while the user is away
    late.freeze(5s);
    QCOMPARE(late.board.stops, 0);
}

void TestDeadMan::whatWasLeftRunningIsNotStopped()
{
    Attended bench;
    bench.live(1s);
    bench.session.setArmed(false);
    bench.freeze(1min);
    bench.live(1s);
    QCOMPARE(bench.board.stops, 0);
    QVERIFY(bench.interruptions.empty()); // nothing was changed
    bench.session.setArmed(true); // the user takes it over again
    bench.freeze(3s);
    QCOMPARE(bench.board.stops, 1);
}

void TestDeadMan::whatSomebodyElseStartedIsNotStopped()
{
    Attended bench(MotorState::Running, false);
    bench.freeze(1min);
    QCOMPARE(bench.board.stops, 0);
    // What was armed here once, and has come to rest, is over.
    Attended over(MotorState::Running);
    over.session.stop();
    over.tell(MotorState::Idle);
    over.live(1s);
    over.tell(MotorState::Running);
    over.freeze(1min);
    QCOMPARE(over.board.stops, 1);
}

void TestDeadMan::aLostLinkIsNoLeavingRunning()
{
    Attended bench;
    bench.drive().disarm(); // as drives do then
    bench.turn();
    bench.session.setArmed(false); // and as windows follow
    bench.freeze(3s);
    QCOMPARE(bench.board.stops, 1);
}

void TestDeadMan::theFirstStampAfterwardsArmsNothing()
{
    Attended bench;
    bench.freeze(3s);
    bench.live(10s);
    QVERIFY(!bench.drive().armed());
    QCOMPARE(bench.armed, (std::vector<bool>{true, false}));
    bench.session.setArmed(true); // only the user does
    QVERIFY(bench.drive().armed());
}

void TestDeadMan::anInterfaceThatNeverStampsCannotArm()
{
    Bench bench(Attendance::Stamped);
    bench.session.open(Bench::serial());
    bench.runUntil(bench.now + 600ms);
    bench.session.setArmed(true);
    QVERIFY(!bench.drive().armed());
    QCOMPARE(bench.interruptions.size(), 1U);
    QVERIFY(bench.interruptions[0].cause == Cause::LateArming);
}

void TestDeadMan::armingThatComesLateIsNotDone()
{
    Attended bench(MotorState::Idle, false);
    bench.live(1s);
    bench.session.setArmed(true, bench.now - drive::kWishExpiresAfter - 1ms);
    QVERIFY(!bench.drive().armed());
    QCOMPARE(bench.interruptions.size(), 1U);
    QVERIFY(bench.interruptions[0].cause == Cause::LateArming);
    bench.session.setArmed(true, bench.now - drive::kWishExpiresAfter);
    QVERIFY(bench.drive().armed());
    bench.session.setArmed(false, bench.now - 1h); // never too late
    QVERIFY(!bench.drive().armed());
}

void TestDeadMan::anInterfaceInTheSessionsThreadIsThere()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.session.setArmed(true);
    bench.drive().timeout = bench.now + 1min;
    bench.runUntil(bench.now + 2min);
    QVERIFY(bench.drive().armed());
    QCOMPARE(bench.board.stops, 0);
}

void TestDeadMan::eachConnectionBeginsAnew()
{
    Attended bench;
    bench.session.close();
    bench.session.open(Bench::serial());
    bench.tell(MotorState::Running);
    bench.freeze(1min);
    QCOMPARE(bench.board.stops, 0); // this one was never armed
}

void TestDeadMan::aSleepDisarmsAndDoubts()
{
    Attended bench(MotorState::Idle);
    bench.live(1s);
    bench.slept = 8h;
    bench.turn();
    QCOMPARE(bench.board.doubts, 1);
    QVERIFY(!bench.drive().armed());
    bench.live(1s);
    QCOMPARE(bench.board.doubts, 1);
    QCOMPARE(bench.board.stops, 0);
    QCOMPARE(bench.interruptions.size(), 1U);
    QVERIFY(bench.interruptions[0].cause == Cause::Gap);
    QVERIFY(bench.interruptions[0].disarmed);
    QVERIFY(bench.interruptions[0].length > 7h);
}

void TestDeadMan::aLateWakeDisarmsAndDoubts()
{
    Attended bench(MotorState::Idle);
    bench.live(1s);
    bench.drive().timeout = bench.now + 50ms;
    bench.turn();
    bench.now += 1051ms; // its interface lives meanwhile
    bench.session.attendFromAnyThread();
    bench.turn();
    QCOMPARE(bench.board.doubts, 1);
    QVERIFY(!bench.drive().armed());
    QCOMPARE(bench.interruptions.size(), 1U);
    QVERIFY(bench.interruptions[0].cause == Cause::Gap);
}

void TestDeadMan::whatWaitedToLeaveDoesNotLeaveBehindAGap_data()
{
    QTest::addColumn<Duration>("away");
    QTest::addColumn<bool>("stopping");
    QTest::addColumn<bool>("leaves");
    QTest::newRow("a moment") << Duration(200ms) << false << true;
    QTest::newRow("a sleep") << Duration(2s) << false << false;
    QTest::newRow("a sleep during a stop") << Duration(2s) << true << true;
}

/// Behind the header of a packet there is a pause, and a computer may be put to sleep in it.
void TestDeadMan::whatWaitedToLeaveDoesNotLeaveBehindAGap()
{
    QFETCH(Duration, away);
    QFETCH(bool, stopping);
    QFETCH(bool, leaves);
    Attended bench;
    bench.live(1s);
    const Bytes header{0x29, 0, 0, 0xE0}, payload{0x19, 0};
    bench.drive().outputs = {{header, {}}, {payload, 1500us}};
    bench.drive().stopping = stopping;
    bench.turn();
    QCOMPARE(bench.port.written.back().bytes, header);
    bench.now += away;
    bench.session.attendFromAnyThread();
    bench.turn();
    QCOMPARE(bench.port.written.back().bytes == payload, leaves);
}

/// A thread that gets the processor late, by any time: within a second it is taken as it is, beyond it is a gap.
void TestDeadMan::wakesOfEveryLatenessAreJudgedRightly()
{
    std::uint64_t state = 1;
    for (int round = 0; round < 500; ++round) {
        state = state * 6364136223846793005U + 1442695040888963407U;
        const Duration late = std::chrono::milliseconds(state >> 33 & 0x7FF); // 0 to 2047 ms
        Attended bench;
        bench.live(300ms);
        const TimePoint due = *bench.session.nextStep();
        for (; bench.now < due + late; bench.now = std::min(bench.now + 100ms, due + late))
            bench.session.attendFromAnyThread(); // a lively interface
        bench.turn();
        QCOMPARE(bench.board.doubts, late > session::TimeGap::kLeast ? 1 : 0);
        QCOMPARE(bench.drive().armed(), late <= session::TimeGap::kLeast);
        bench.live(300ms);
        QCOMPARE(bench.board.doubts, late > session::TimeGap::kLeast ? 1 : 0);
    }
}

void TestDeadMan::whatWasQueuedDuringAGapComesAfterIt()
{
    Attended bench(MotorState::Idle);
    bench.live(1s);
    bench.now += 8s;
    // No turn yet: the call that waited in the queue is the first to run.
    bench.session.submit({.id = 7, .what = drive::Command{drive::MotorAction::Start, 1}});
    QCOMPARE(bench.board.doubts, 1);
    QCOMPARE(bench.board.armedAtWish, false);
    Attended arming(MotorState::Idle, false);
    arming.live(1s);
    arming.now += 8s;
    arming.session.setArmed(true);
    QVERIFY(!arming.drive().armed());
}

void TestDeadMan::aStandstillOfBothStopsWhateverWakesFirst()
{
    for (const bool interfaceFirst : {true, false}) {
        Attended bench;
        bench.live(1s);
        bench.now += 8s;
        if (interfaceFirst)
            bench.session.attendFromAnyThread();
        bench.turn();
        QVERIFY(!bench.drive().armed());
        QCOMPARE(bench.board.doubts, 1);
        QCOMPARE(bench.board.stops, 1);
        bench.live(1s);
        QCOMPARE(bench.board.stops, 1);
        QCOMPARE(bench.interruptions.size(), 1U);
        QVERIFY(bench.interruptions[0].cause == Cause::Gap);
        QVERIFY(bench.interruptions[0].disarmed && bench.interruptions[0].stopped);
    }
}

void TestDeadMan::aStandstillOfAProgramWithOneThreadStopsToo()
{
    Bench bench;
    bench.session.open(Bench::serial());
    bench.session.setArmed(true);
    bench.drive().events.push_back(status(MotorState::Running));
    bench.drive().timeout = bench.now + 50ms;
    bench.turn();
    bench.now += 8s;
    bench.turn();
    QVERIFY(!bench.drive().armed());
    QCOMPARE(bench.board.stops, 1);
    QCOMPARE(bench.interruptions.size(), 1U);
    QVERIFY(bench.interruptions[0].cause == Cause::Gap && bench.interruptions[0].stopped);
}

void TestDeadMan::whatIsNotArmedIsOnlyDoubted()
{
    Attended bench(MotorState::Running, false);
    bench.live(1s);
    bench.slept = 1h;
    bench.turn();
    bench.live(1s);
    QCOMPARE(bench.board.doubts, 1);
    QCOMPARE(bench.board.stops, 0);
    QVERIFY(bench.interruptions.empty());
}

void TestDeadMan::aHoldWithItsStampsGoesOn()
{
    Attended bench;
    for (int i = 0; i < 100; ++i) {
        bench.session.holdFromAnyThread(1);
        bench.live(50ms);
    }
    bench.session.releaseFromAnyThread();
    bench.live(5s);
    QCOMPARE(bench.motorStops(), 0); // letting go is the interface's to do
    QVERIFY(bench.interruptions.empty());
}

void TestDeadMan::aHoldThatIsNotHeardOfStopsItsMotor()
{
    Attended bench;
    bench.tell(MotorState::Running, 2);
    bench.session.holdFromAnyThread(2);
    bench.turn();
    const TimePoint held = bench.now;
    bench.freeze(DeadMan::kHoldsFor);
    QCOMPARE(bench.motorStops(), 0);
    bench.freeze(1ms);
    QCOMPARE(bench.motorStops(), 1);
    QVERIFY(bench.now - held < 310ms);
    const auto &wish = bench.board.wishes.back();
    QCOMPARE(std::get<drive::Command>(wish.what).motor, 2);
    bench.tell(MotorState::Idle, 2);
    bench.live(3s);
    QCOMPARE(bench.board.stops, 0); // there was evidence
    QCOMPARE(bench.motorStops(), 1);
    QCOMPARE(bench.interruptions.size(), 1U);
    QVERIFY(bench.interruptions[0].cause == Cause::Hold);
    QVERIFY(bench.drive().armed()); // 300 ms are no absence
}

void TestDeadMan::whatDoesNotStopThenIsStoppedForGood()
{
    Attended bench;
    bench.session.holdFromAnyThread(1);
    bench.live(301ms + DeadMan::kIdleWithin);
    QCOMPARE(bench.motorStops(), 1);
    bench.live(100ms);
    QCOMPARE(bench.board.stops, 1);
}

void TestDeadMan::aHoldThatEndedIsNotRevived()
{
    Attended bench;
    bench.session.holdFromAnyThread(1);
    bench.live(400ms);
    bench.tell(MotorState::Idle);
    QCOMPARE(bench.motorStops(), 1);
    for (int i = 0; i < 20; ++i) { // the release waits behind these in a window that thaws
        bench.session.holdFromAnyThread(1);
        bench.live(50ms);
    }
    QCOMPARE(bench.motorStops(), 1);
    bench.session.releaseFromAnyThread();
    bench.session.holdFromAnyThread(1); // a new one, before the session looks
    bench.live(200ms);
    QCOMPARE(bench.motorStops(), 1);
    bench.live(200ms);
    QCOMPARE(bench.motorStops(), 2);
}

void TestDeadMan::theHeartOfTheInterfaceHoldsNothing()
{
    Attended bench;
    bench.session.holdFromAnyThread(1);
    for (int i = 0; i < 4; ++i) {
        bench.session.attendFromAnyThread();
        bench.freeze(100ms);
    }
    QCOMPARE(bench.motorStops(), 1);
}

void TestDeadMan::askedToEndItStopsWhatItDrives()
{
    Attended bench;
    bench.live(1s);
    bench.freeze(100ms); // the interface need not be alive
    bench.session.stopOwn();
    QCOMPARE(bench.board.stops, 1);
    Attended disarmedByFreeze;
    disarmedByFreeze.freeze(1s);
    disarmedByFreeze.session.stopOwn();
    QCOMPARE(disarmedByFreeze.board.stops, 1);
}

void TestDeadMan::askedToEndItLeavesWhatIsNotItsOwn()
{
    Attended left;
    left.session.setArmed(false);
    left.session.stopOwn();
    QCOMPARE(left.board.stops, 0);
    Attended onlyLooking(MotorState::Running, false);
    onlyLooking.session.stopOwn();
    QCOMPARE(onlyLooking.board.stops, 0);
    Bench closed;
    closed.session.stopOwn();
    QCOMPARE(closed.board.stops, 0);
}

void TestDeadMan::aFrozenInterfaceIsSeenByTheRunningThread()
{
    Threaded rig;
    const auto frozen = std::chrono::steady_clock::now();
    rig.arm();
    while (rig.stops == 0 && std::chrono::steady_clock::now() - frozen < 30s)
        QThread::yieldCurrentThread(); // this thread is the interface, and has no event loop here
    QCOMPARE(rig.stops.load(), 1);
    QVERIFY(std::chrono::steady_clock::now() - frozen >= DeadMan::kGoneAfter);
}

void TestDeadMan::aStarvedSessionDisarmsWhenItRunsAgain()
{
    Threaded rig;
    rig.arm();
    QVERIFY(rig.armed());
    const auto begun = std::chrono::steady_clock::now();
    const auto busy = [begun](std::chrono::milliseconds time) {
        return std::chrono::steady_clock::now() - begun < time;
    };
    QMetaObject::invokeMethod(
        rig.thread.session(),
        [busy] {
            while (busy(1500ms)) { }
        },
        Qt::QueuedConnection);
    while (busy(1500ms)) {
        rig.thread.session()->attendFromAnyThread(); // a lively interface
        QThread::yieldCurrentThread();
    }
    while (rig.armed() && busy(30s)) // until its timer has had its turn
        rig.thread.session()->attendFromAnyThread();
    QVERIFY(!rig.armed());
    QVERIFY(rig.doubts() >= 1);
    QCOMPARE(rig.stops.load(), 0); // the user was there
}

QTEST_GUILESS_MAIN(TestDeadMan)
#include "tst_dead_man.moc"
