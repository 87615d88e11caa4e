// DrivenMotors: from when on, and until when, a motor counts as set going here. Numbers and times only.
#include "session/link/driven_motors.h"

#include <QTest>

using namespace drive;
using namespace std::chrono_literals;
using session::DrivenMotors;

namespace {

constexpr TimePoint kStarted{10s};

Event toldStatus(MotorState state, Duration at, int motor = 1, bool waits = false)
{
    MotorStatus status;
    status.motor = motor;
    status.state = state;
    status.waitsForBus = waits;
    status.at = kStarted + at;
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

struct MotorsBench {
    DrivenMotors motors;

    void start(WishId id, Duration at = {})
    {
        motors.submitted({.id = id, .what = Command{}}, true, kStarted + at);
    }
    /// At rest once that many such states were told.
    int readingsUntilRest(MotorState state, Duration at, bool waits = false)
    {
        for (int i = 1; i < 5; ++i) {
            motors.told(toldStatus(state, at, 1, waits), kStarted + at);
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
        motors.submitted({.id = 1, .what = what}, false, kStarted);
        QVERIFY(!motors.any()); // unarmed
        motors.submitted({.id = 1, .what = what}, true, kStarted);
        QCOMPARE(motors.any(), moves);
    }
}

void TestDrivenMotors::onlyWhatActsHereDrives()
{
    MotorsBench bench;
    for (int i = 0; i < 3; ++i)
        bench.motors.told(toldStatus(MotorState::Running, 1s), kStarted + 1s);
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
        MotorsBench bench;
        bench.start(0); // nothing ends it
        QCOMPARE(bench.readingsUntilRest(state, 299ms), 0);
        QCOMPARE(bench.readingsUntilRest(state, 300ms), rests ? 2 : 0);
    }
    MotorsBench waits; // for its bus: it starts by itself then
    waits.start(0);
    QCOMPARE(waits.readingsUntilRest(MotorState::Idle, 1s, true), 0);
    MotorsBench row;
    row.start(0);
    for (const MotorState state : {MotorState::Idle, MotorState::Running, MotorState::Idle})
        row.motors.told(toldStatus(state, 1s), kStarted + 1s);
    QVERIFY(row.motors.any());
    QCOMPARE(row.readingsUntilRest(MotorState::Idle, 1s), 1);
}

void TestDrivenMotors::anOpenWishMayMoveAnyTime()
{
    MotorsBench bench;
    bench.start(7);
    bench.motors.told(endOf(8), kStarted + 1s); // another one
    QCOMPARE(bench.readingsUntilRest(MotorState::Idle, 5s), 0);
    bench.motors.told(endOf(7), kStarted + 5s);
    QCOMPARE(bench.readingsUntilRest(MotorState::Idle, 5s + 299ms), 0);
    bench.motors.told(toldStatus(MotorState::Idle, 5s + 300ms), kStarted + 6s);
    bench.motors.told(endOf(8), kStarted + 6s); // says nothing about the motor
    QCOMPARE(bench.readingsUntilRest(MotorState::Idle, 5s + 300ms), 1);
}

void TestDrivenMotors::whatIsAskedForAnewBeginsAnew()
{
    MotorsBench bench;
    bench.start(0);
    bench.motors.told(toldStatus(MotorState::Idle, 1s), kStarted + 1s);
    bench.start(0, 1s);
    QCOMPARE(bench.readingsUntilRest(MotorState::Idle, 1s + 299ms), 0);
    QCOMPARE(bench.readingsUntilRest(MotorState::Idle, 1s + 300ms), 2);
    bench.start(3, 2s);
    bench.motors.told(endOf(3), kStarted + 2s);
    bench.motors.told(toldStatus(MotorState::Idle, 3s), kStarted + 3s);
    bench.start(4, 3s);
    bench.motors.told(endOf(4), kStarted + 3s);
    QCOMPARE(bench.readingsUntilRest(MotorState::Idle, 4s), 2);
}

void TestDrivenMotors::everyMotorHasToRest()
{
    MotorsBench bench;
    bench.motors.told(boardOf(2), kStarted);
    bench.start(0);
    QCOMPARE(bench.readingsUntilRest(MotorState::Idle, 1s), 0);
    bench.motors.told(toldStatus(MotorState::Idle, 1s, 2), kStarted + 1s);
    QVERIFY(bench.motors.any());
    bench.motors.told(toldStatus(MotorState::Idle, 1s, 2), kStarted + 1s);
    QVERIFY(!bench.motors.any());
}

QTEST_APPLESS_MAIN(TestDrivenMotors)
#include "tst_driven_motors.moc"
