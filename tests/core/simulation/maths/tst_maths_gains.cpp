// The gains of all loops against worked examples and against the numbers of a project that ST's tool generated, and a
// current loop that has the bandwidth it was designed for.
#include "simulation/maths/gains.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace simulation;

namespace {

bool within(double value, double expected, double share)
{
    return std::abs(value - expected) <= share * std::abs(expected);
}

} // namespace

class TestMathsGains : public QObject {
    Q_OBJECT

private slots:
    void theWorkedExampleOfTheCurrentLoopIsMet();
    void theGeneratedProjectsCurrentLoopIsMet();
    void theGeneratedProjectsObserverIsMet();
    void aBackEmfThatIsSmallForItsInductanceTakesASmallerF2();
    void aFractionTakesTheShiftThatFits();
    void theSpeedLoopHasTheGainsOfTheSymmetricalOptimum();
    void thePllHasTheFrequencyAskedFor();
    void aCurrentStepRisesAsDesigned_data();
    void aCurrentStepRisesAsDesigned();
    void aSpeedStepOvershootsAsTheSymmetricalOptimumDoes_data();
    void aSpeedStepOvershootsAsTheSymmetricalOptimumDoes();
};

void TestMathsGains::theWorkedExampleOfTheCurrentLoopIsMet()
{
    const CurrentSensing sensing; // 24 V, 3 mOhm, 9.14, 3.3 V
    QVERIFY(within(sensing.loopGain(), 0.199418, 1e-5));
    QVERIFY(within(sensing.digitsPerAmp(), 544.54, 1e-5));
    QVERIFY(within(sensing.maxCurrent_a(), 60.175, 1e-5));
    const Pi::Gains gains = currentGains(0.6e-3, 0.35, 1500.0, sensing, 16000.0);
    QCOMPARE(gains.kp, std::int16_t{4621});
    QCOMPARE(gains.kpShift, 10);
    QCOMPARE(gains.ki, std::int16_t{2696});
    QCOMPARE(gains.kiShift, 14);
}

void TestMathsGains::theGeneratedProjectsCurrentLoopIsMet()
{
    const Pi::Gains gains = currentGains(0.117e-3, 0.03, 6000.0, {}, 16000.0);
    QVERIFY(within(gains.kp, 3614, 0.003));
    QCOMPARE(gains.kpShift, 10);
    QVERIFY(within(gains.ki, 925, 0.003));
    QCOMPARE(gains.kiShift, 14);
}

void TestMathsGains::theGeneratedProjectsObserverIsMet()
{
    const ObserverConstants c = observerGains({.rs_ohm = 0.03,
        .ls_h = 0.117e-3,
        .hfHz = 16000.0,
        .maxCurrent_a = CurrentSensing{}.maxCurrent_a(),
        .maxBemf_v = 29.0, // 0.9 V rms a 1000 rpm, at 1.2 * 33000 rpm, cut to volts
        .maxVoltage_v = 36.0});
    QCOMPARE(c.gain1, std::int16_t{-24379});
    QVERIFY(within(c.gain2, 18041, 0.003));
    QCOMPARE(c.c1, std::int16_t{262}); // 16384 * 0.03 / (0.117e-3 * 16000): 262.56
    QCOMPARE(c.c3, std::int16_t{4217});
    QCOMPARE(c.c5, std::int16_t{5236});
    QCOMPARE(c.f1Shift, 14);
    QCOMPARE(c.f2Shift, 13);
}

void TestMathsGains::aBackEmfThatIsSmallForItsInductanceTakesASmallerF2()
{
    const ObserverConstants c = observerGains({.rs_ohm = 0.35,
        .ls_h = 0.6e-3,
        .hfHz = 16000.0,
        .maxCurrent_a = 60.175,
        .maxBemf_v = 13.0,
        .maxVoltage_v = 36.0});
    QCOMPARE(c.f2Shift, 10);
    QVERIFY(within(c.gain2,
        1024.0 * 0.6e-3 * 16000.0 * 0.75 * (1.0 - 0.25 * (1.0 - 0.35 / 9.6)) * 60.175 / 13.0,
        1e-4));
}

void TestMathsGains::aFractionTakesTheShiftThatFits()
{
    const Fraction fits = fractionOf(4.51313, 10);
    QCOMPARE(fits.numerator, std::int16_t{4621});
    QVERIFY(within(std::ldexp(fits.numerator, -fits.shift), 4.51313, 1e-3));
    const Fraction large = fractionOf(100.0, 10);
    QCOMPARE(large.shift, 8);
    QCOMPARE(large.numerator, std::int16_t{25600});
    const Fraction negative = fractionOf(-33.0, 10);
    QCOMPARE(negative.numerator, std::int16_t{-16896});
    QCOMPARE(negative.shift, 9);
    const Fraction hopeless = fractionOf(1e9, 10);
    QCOMPARE(hopeless.numerator, std::int16_t{32767});
    QCOMPARE(hopeless.shift, 0);
}

void TestMathsGains::theSpeedLoopHasTheGainsOfTheSymmetricalOptimum()
{
    const SpeedLoop loop{.inertia_kgm2 = 5e-5,
        .torqueConstant_nmPerA = 1.5 * 4 * 6.5e-3,
        .currentBandwidth_radps = 1500.0,
        .filter_s = 2e-3,
        .damping = 4.0};
    const double tau = 1.0 / 1500.0 + 2e-3 + 1.5 / 16000.0 + 0.5e-3;
    QVERIFY(within(loop.lag_s(), tau, 1e-9));
    QVERIFY(within(loop.crossover_radps(), 1.0 / (4.0 * tau), 1e-9));
    const Pi::Gains gains = speedGains(loop, {});
    const double kp = 5e-5 / (0.039 * 4.0 * tau), scale = 2.0 * std::numbers::pi / 10.0 * 544.54;
    QVERIFY(within(std::ldexp(gains.kp, -gains.kpShift), kp * scale, 1e-3));
    QVERIFY(within(std::ldexp(gains.ki, -gains.kiShift), kp / (16.0 * tau) * scale / 1000.0, 1e-2));
}

void TestMathsGains::thePllHasTheFrequencyAskedFor()
{
    const Pi::Gains gains = pllGains(960.0, 0.85, 27300.0, 16000.0);
    // Digits out a digit of angle.
    const double perRadian = 27300.0 * 2.0 * std::numbers::pi / 65536.0;
    const double ki = std::ldexp(gains.ki, -gains.kiShift) * perRadian;
    QVERIFY(within(std::sqrt(ki) * 16000.0, 960.0, 0.02));
    const double kp = std::ldexp(gains.kp, -gains.kpShift) * perRadian;
    QVERIFY(within(kp * 16000.0, 2.0 * 0.85 * 960.0, 0.02));
}

void TestMathsGains::aCurrentStepRisesAsDesigned_data()
{
    QTest::addColumn<double>("bandwidth");
    QTest::addColumn<double>("volts");
    QTest::addColumn<double>("expected");
    for (const double bandwidth : {1000.0, 1500.0}) {
        QTest::addRow("%g rad/s, a digit as ST's rule has it", bandwidth)
            << bandwidth << 24.0 / 65536.0 << bandwidth;
        QTest::addRow("%g rad/s, a digit as modulated", bandwidth)
            << bandwidth << 24.0 / (std::numbers::sqrt3 * 32768.0)
            << bandwidth * 2.0 / std::numbers::sqrt3;
    }
}

/// A locked winding behind the fixed-point controller, its voltage set once a period.
void TestMathsGains::aCurrentStepRisesAsDesigned()
{
    QFETCH(double, bandwidth);
    QFETCH(double, volts);
    QFETCH(double, expected);
    constexpr double kRs = 0.35, kLs = 0.6e-3, kHf = 16000.0;
    const CurrentSensing sensing;
    Pi pi(currentGains(kLs, kRs, bandwidth, sensing, kHf));
    const double decay = std::exp(-kRs / kLs / kHf);
    constexpr double kStep_a = 3.0;
    const double target = kStep_a * sensing.digitsPerAmp();
    double current_a = 0.0, peak_a = 0.0, t10 = 0.0, t90 = 0.0;
    for (int i = 1; i < 400; ++i) {
        const double was = current_a;
        const double measured = current_a * sensing.digitsPerAmp();
        const auto error = static_cast<std::int32_t>(std::lround(target - measured));
        const double v = pi.step(error) * volts;
        current_a = decay * current_a + (1.0 - decay) * v / kRs;
        peak_a = std::max(peak_a, current_a);
        const auto crossing = [&](double level, double &at) {
            if (at == 0.0 && current_a >= level * kStep_a)
                at = (i - 1 + (level * kStep_a - was) / (current_a - was)) / kHf;
        };
        crossing(0.1, t10);
        crossing(0.9, t90);
    }
    QVERIFY2(within(t90 - t10, 2.2 / expected, 0.1),
        QByteArray::number((t90 - t10) * expected).constData());
    QVERIFY2(peak_a < 1.05 * kStep_a, QByteArray::number(peak_a).constData());
    QVERIFY(within(current_a, kStep_a, 0.01));
}

void TestMathsGains::aSpeedStepOvershootsAsTheSymmetricalOptimumDoes_data()
{
    QTest::addColumn<double>("damping");
    QTest::addColumn<double>("overshoot");
    QTest::newRow("d = 2") << 2.0 << 0.43;
    QTest::newRow("d = 2.41") << 2.41 << 0.34;
    QTest::newRow("d = 3") << 3.0 << 0.25;
    QTest::newRow("d = 4") << 4.0 << 0.17;
    QTest::newRow("d = 6") << 6.0 << 0.11;
}

/// An inertia behind one lag, which stands for all of them but that of the sampling; speeds in whole 0.1 Hz.
void TestMathsGains::aSpeedStepOvershootsAsTheSymmetricalOptimumDoes()
{
    QFETCH(double, damping);
    QFETCH(double, overshoot);
    const CurrentSensing sensing;
    const SpeedLoop loop{.inertia_kgm2 = 5e-5,
        .torqueConstant_nmPerA = 0.039,
        .currentBandwidth_radps = 1500.0,
        .filter_s = 2e-3,
        .damping = damping};
    Pi pi(speedGains(loop, sensing));
    const double lag_s = loop.lag_s() - 0.5 / loop.mfHz;
    constexpr int kSteps = 100;
    const double dt = 1.0 / loop.mfHz / kSteps;
    constexpr int kStep_dHz = 200;
    double speed_radps = 0.0, current_a = 0.0, peak_dHz = 0.0;
    for (int tick = 0; tick < 400; ++tick) {
        const auto measured =
            static_cast<int>(std::lround(speed_radps * 10.0 / (2.0 * std::numbers::pi)));
        const double wanted_a = pi.step(kStep_dHz - measured) / sensing.digitsPerAmp();
        for (int i = 0; i < kSteps; ++i) {
            current_a += (wanted_a - current_a) * dt / lag_s;
            speed_radps += loop.torqueConstant_nmPerA * current_a / loop.inertia_kgm2 * dt;
        }
        peak_dHz = std::max(peak_dHz, speed_radps * 10.0 / (2.0 * std::numbers::pi));
    }
    const double is = peak_dHz / kStep_dHz - 1.0;
    QVERIFY2(std::abs(is - overshoot) < 0.03, QByteArray::number(is).constData());
    QVERIFY(within(speed_radps * 10.0 / (2.0 * std::numbers::pi), kStep_dHz, 0.01));
}

QTEST_APPLESS_MAIN(TestMathsGains)
#include "tst_maths_gains.moc"
