// The controller's limits, its discharge, and what writing its shifts does.
#include "simulation/maths/pi.h"

#include <QTest>

using namespace simulation;

class TestMathsPi : public QObject {
    Q_OBJECT

private slots:
    void itIsProportionalPlusSum();
    void shiftsRoundTowardsMinusInfinity();
    void noErrorIsSoLargeThatItWraps();
    void heldAtTheLimitTheIntegralDischarges();
    void itLeavesTheLimitWhenTheErrorTurns();
    void withoutKiThereIsNoIntegral();
    void writingTheShiftRewritesTheLimitsOfTheIntegral();
    void followingTheRegistersLeavesOwnLimitsAlone();
    void shiftsThatNoRegisterHasAreCut();
};

namespace {

/// What the integral is cut to.
std::int32_t mostIntegral(Pi pi)
{
    pi.setIntegral(std::numeric_limits<std::int32_t>::max());
    pi.step(0);
    return pi.integral();
}

std::int32_t leastIntegral(Pi pi)
{
    pi.setIntegral(std::numeric_limits<std::int32_t>::min());
    pi.step(0);
    return pi.integral();
}

} // namespace

void TestMathsPi::itIsProportionalPlusSum()
{
    Pi pi({.kp = 4621, .ki = 2696, .kpShift = 10, .kiShift = 14});
    std::int32_t sum = 0;
    for (const std::int32_t error : {100, 250, -30, 7, 0}) {
        sum += 2696 * error;
        QCOMPARE(pi.step(error), static_cast<std::int16_t>((4621 * error >> 10) + (sum >> 14)));
        QCOMPARE(pi.integral(), sum);
    }
}

void TestMathsPi::shiftsRoundTowardsMinusInfinity()
{
    Pi pi({.kp = 1, .ki = 0, .kpShift = 4, .kiShift = 0});
    QCOMPARE(pi.step(1), std::int16_t{0});
    QCOMPARE(pi.step(-1), std::int16_t{-1});
}

void TestMathsPi::noErrorIsSoLargeThatItWraps()
{
    Pi pi({.kp = 32767, .ki = 32767, .kpShift = 0, .kiShift = 0});
    for (int i = 0; i < 100; ++i) {
        QCOMPARE(pi.step(2147483647), std::int16_t{32767});
        QVERIFY(pi.integral() <= 32767);
    }
    for (int i = 0; i < 100; ++i)
        pi.step(-2147483647);
    QCOMPARE(pi.step(-2147483647), std::int16_t{-32767});
}

void TestMathsPi::heldAtTheLimitTheIntegralDischarges()
{
    Pi pi({.kp = 1000, .ki = 1, .kpShift = 0, .kiShift = 14});
    pi.setIntegral(10000 << 14);
    QCOMPARE(pi.step(100), std::int16_t{32767}); // 100000 + 10000: 77233 too much
    QCOMPARE(pi.integral(), (10000 << 14) + 100 - 77233);
    const std::int32_t was = pi.integral();
    for (int i = 0; i < 50; ++i)
        pi.step(100);
    QVERIFY(pi.integral() < was - 50 * 70000); // less every time, whatever ki adds
}

void TestMathsPi::itLeavesTheLimitWhenTheErrorTurns()
{
    Pi pi({.kp = 0, .ki = 1000, .kpShift = 0, .kiShift = 4});
    pi.setOutputLimits({-500, 500});
    for (int i = 0; i < 1000; ++i)
        QVERIFY(pi.step(1000) <= 500);
    // what piles up past the limit is bounded by the limits of the integral, not by how long it was held
    QVERIFY(pi.integral() <= 32767 << 4);
    pi.setIntegralLimits({-500 << 4, 500 << 4});
    QCOMPARE(pi.step(1000), std::int16_t{500});
    QCOMPARE(pi.step(-1), std::int16_t{437}); // 8000 - 1000, at once
}

void TestMathsPi::withoutKiThereIsNoIntegral()
{
    Pi pi({.kp = 16, .ki = 100, .kpShift = 4, .kiShift = 0});
    pi.step(50);
    QVERIFY(pi.integral() != 0);
    pi.follow({.kp = 16, .ki = 0, .kpShift = 4, .kiShift = 0});
    QCOMPARE(pi.step(50), std::int16_t{50});
    QCOMPARE(pi.integral(), 0);
}

void TestMathsPi::writingTheShiftRewritesTheLimitsOfTheIntegral()
{
    Pi pi({.kp = 0, .ki = 1, .kpShift = 0, .kiShift = 14});
    QCOMPARE(mostIntegral(pi), 32767 << 14);
    pi.setIntegralLimits({-5, 5});
    pi.setKiShift(14); // the same value, written again
    QCOMPARE(leastIntegral(pi), -(32767 << 14));
    pi.setKiShift(3);
    QCOMPARE(mostIntegral(pi), 32767 << 3);
    pi.setKiShift(17);
    QCOMPARE(mostIntegral(pi), 2147483647);
}

void TestMathsPi::followingTheRegistersLeavesOwnLimitsAlone()
{
    Pi pi({.kp = 1, .ki = 1, .kpShift = 10, .kiShift = 14});
    pi.setIntegralLimits({-5, 5});
    pi.follow({.kp = 7, .ki = 9, .kpShift = 11, .kiShift = 14});
    QCOMPARE(pi.kp(), std::int16_t{7});
    QCOMPARE(pi.ki(), std::int16_t{9});
    QCOMPARE(pi.kpShift(), 11);
    QCOMPARE(mostIntegral(pi), 5);
    pi.follow({.kp = 7, .ki = 9, .kpShift = 11, .kiShift = 13});
    QCOMPARE(mostIntegral(pi), 32767 << 13);
}

void TestMathsPi::shiftsThatNoRegisterHasAreCut()
{
    Pi pi({.kp = 1, .ki = 1, .kpShift = 99, .kiShift = -4});
    QCOMPARE(pi.kpShift(), 31);
    QCOMPARE(pi.kiShift(), 0);
    QCOMPARE(pi.step(1000), std::int16_t{1000});
    pi.setOutputLimits({-100000, 100000});
    QCOMPARE(pi.step(-100000), std::int16_t{-32768});
    QCOMPARE(pi.step(100000), std::int16_t{32767});
}

QTEST_APPLESS_MAIN(TestMathsPi)
#include "tst_maths_pi.moc"
