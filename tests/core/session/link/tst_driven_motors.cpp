// DrivenMotors: from when on, and until when, a motor counts as set going here. Numbers and times only.
#include "session/link/driven_motors.h"

#include <QTest>

using namespace drive;
using namespace std::chrono_literals;
using session::DrivenMotors;

namespace {

constexpr TimePoint t{10s};

Event statusOf(MotorState state, Duration at, int motor = 1, bool waits = false)
{
    MotorStatus status;
    status.motor = motor;
    status.state = state;
    status.waitsForBus = waits;
    status.at = t + at;
    return status;
}

Event endOf(WishId id)
{
    return Ended{.id = id, .outcome = Outcome::Ok, .reason = {}, .writes = {}};
}

Event boardOf(int motors)
{
    Identified board{};
    board.identity.motors = motors;
    return board;
}

struct Bench {
    DrivenMotors motors;

    void start(WishId id, Duration at = {})
    {
        motors.submitted({.id = id, .what = Command{}}, true, t + at);
    }
    /// At rest once that many such states were told.
    int readingsUntilRest(MotorState state, Duration at, bool waits = false)
    {
        for (int i = 1; i < 5; ++i) {
            motors.told(statusOf(state, at, 1, waits), t + at);
            if (!motors.any())
                return i;
        }
        return 0;
    }
};

} // namespace

class TestDrivenMotors : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatCanMoveDrives();
    void onlyWhatActsHereDrives();
    void restIsSeenTwiceInARowWellBehindTheEnd();
    void anOpenWishMayMoveAnyTime();
    void whatIsAskedForAnewBeginsAnew();
    void everyMotorHasToRest();
};

void TestDrivenMotors::whatCanMoveDrives()
{
    using What = decltype(Wish::what);
    CyclicSetPoints on, off;
    on.on = true;
    off.on = false;
    const std::pair<What, bool> rows[] = {{Write{}, true}, {Command{MotorAction::Start, 1}, true},
        {SpeedRamp{}, true}, {TorqueRamp{}, true}, {CurrentReference{}, true},
        {PositionRamp{}, true}, {on, true}, {off, false},
        {Command{MotorAction::StopMotor, 1}, false}, {Command{MotorAction::StopRamp, 1}, false},
        {Command{MotorAction::AcknowledgeFaults, 1}, false}, {Read{}, false}, {Stream{}, false}};
    for (const auto &[what, moves] : rows) {
        DrivenMotors motors;
        motors.submitted({.id = 1, .what = what}, false, t);
        QVERIFY(!motors.any()); // unarmed
        motors.submitted({.id = 1, .what = what}, true, t);
        QCOMPARE(motors.any(), moves);
    }
}

void TestDrivenMotors::onlyWhatActsHereDrives()
{
    Bench bench;
    for (int i = 0; i < 3; ++i)
        bench.motors.told(statusOf(MotorState::Running, 1s), t + 1s);
    QVERIFY(!bench.motors.any());
    bench.start(1);
    bench.motors.leave();
    QVERIFY(!bench.motors.any());
}

void TestDrivenMotors::restIsSeenTwiceInARowWellBehindTheEnd()
{
    const std::pair<MotorState, bool> states[] = {{MotorState::Idle, true},
        {MotorState::FaultNow, true}, {MotorState::FaultOver, true}, {MotorState::Running, false},
        {MotorState::Starting, false}, {MotorState::Unknown, false}};
    for (const auto &[state, rests] : states) {
        Bench bench;
        bench.start(0); // nothing ends it
        QCOMPARE(bench.readingsUntilRest(state, 299ms), 0);
        QCOMPARE(bench.readingsUntilRest(state, 300ms), rests ? 2 : 0);
    }
    Bench waits; // for its bus: it starts by itself then
    waits.start(0);
    QCOMPARE(waits.readingsUntilRest(MotorState::Idle, 1s, true), 0);
    Bench row;
    row.start(0);
    for (const MotorState state : {MotorState::Idle, MotorState::Running, MotorState::Idle})
        row.motors.told(statusOf(state, 1s), t + 1s);
    QVERIFY(row.motors.any());
    QCOMPARE(row.readingsUntilRest(MotorState::Idle, 1s), 1);
}

void TestDrivenMotors::anOpenWishMayMoveAnyTime()
{
    Bench bench;
    bench.start(7);
    bench.motors.told(endOf(8), t + 1s); // another one
    QCOMPARE(bench.readingsUntilRest(MotorState::Idle, 5s), 0);
    bench.motors.told(endOf(7), t + 5s);
    QCOMPARE(bench.readingsUntilRest(MotorState::Idle, 5s + 299ms), 0);
    bench.motors.told(statusOf(MotorState::Idle, 5s + 300ms), t + 6s);
    bench.motors.told(endOf(8), t + 6s); // says nothing about the motor
    QCOMPARE(bench.readingsUntilRest(MotorState::Idle, 5s + 300ms), 1);
}

void TestDrivenMotors::whatIsAskedForAnewBeginsAnew()
{
    Bench bench;
    bench.start(0);
    bench.motors.told(statusOf(MotorState::Idle, 1s), t + 1s);
    bench.start(0, 1s);
    QCOMPARE(bench.readingsUntilRest(MotorState::Idle, 1s + 299ms), 0);
    QCOMPARE(bench.readingsUntilRest(MotorState::Idle, 1s + 300ms), 2);
    bench.start(3, 2s);
    bench.motors.told(endOf(3), t + 2s);
    bench.motors.told(statusOf(MotorState::Idle, 3s), t + 3s);
    bench.start(4, 3s);
    bench.motors.told(endOf(4), t + 3s);
    QCOMPARE(bench.readingsUntilRest(MotorState::Idle, 4s), 2);
}

void TestDrivenMotors::everyMotorHasToRest()
{
    Bench bench;
    bench.motors.told(boardOf(2), t);
    bench.start(0);
    QCOMPARE(bench.readingsUntilRest(MotorState::Idle, 1s), 0);
    bench.motors.told(statusOf(MotorState::Idle, 1s, 2), t + 1s);
    QVERIFY(bench.motors.any());
    bench.motors.told(statusOf(MotorState::Idle, 1s, 2), t + 1s);
    QVERIFY(!bench.motors.any());
}

QTEST_APPLESS_MAIN(TestDrivenMotors)
#include "tst_driven_motors.moc"
