// When a motor counts as where it was to go, for experiments and for the command line.
#include "lab/waits.h"

#include <QTest>

using namespace std::chrono_literals;

class TestWaits : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Three digits of the set-point or 3 %, whichever is more, either way round.
    void whatIsNearIsThreeDigitsOrThreePercent()
    {
        drive::MotorLimits limits;
        limits.speedStepRpm = 6.0;
        QVERIFY(lab::isNear(518.0, 500.0, limits) && !lab::isNear(518.5, 500.0, limits));
        QVERIFY(lab::isNear(2060.0, 2000.0, limits) && !lab::isNear(2061.0, 2000.0, limits));
        QVERIFY(lab::isNear(-1940.0, -2000.0, limits) && !lab::isNear(-1939.0, -2000.0, limits));
        QVERIFY(!lab::isNear(2000.0, -2000.0, limits));
        QVERIFY(!lab::isNear({}, 0.0, limits)); // it is not known
        limits.speedStepRpm = 0.0; // nor told
        QVERIFY(lab::isNear(3.0, 0.0, limits) && !lab::isNear(3.1, 0.0, limits));
    }

    /// A hundredth of what it may turn at, and a digit at least.
    void aRotorIsStillWithinAHundredthOrADigit()
    {
        drive::MotorLimits limits;
        limits.speedStepRpm = 6.0;
        QVERIFY(lab::isStill(-40.0, 4000.0, limits) && !lab::isStill(40.5, 4000.0, limits));
        QVERIFY(lab::isStill(6.0, 0.0, limits) && !lab::isStill(6.5, 0.0, limits));
        QVERIFY(lab::isStill({}, 4000.0, limits));
    }

    void aReferenceOfMoreThanAFewDigitsFlows()
    {
        drive::MotorLimits limits;
        limits.nominalCurrentAmps = 10.0;
        QVERIFY(!lab::flows(0.05, limits) && lab::flows(0.051, limits) && lab::flows(-1.0, limits));
    }

    /// 200 ms without a break; what only passes by is not reached.
    void aSpeedIsReachedWhenItStays()
    {
        lab::Settling settling;
        const TimePoint t{1h};
        QVERIFY(!settling.settled(true, t) && !settling.settled(true, t + 199ms));
        QVERIFY(!settling.settled(false, t + 200ms));
        QVERIFY(!settling.settled(true, t + 300ms) && !settling.settled(true, t + 499ms));
        QVERIFY(settling.settled(true, t + 500ms) && settling.settled(true, t + 5s));
        QVERIFY(!settling.settled(false, t + 6s));
    }
};

QTEST_APPLESS_MAIN(TestWaits)
#include "tst_waits.moc"
