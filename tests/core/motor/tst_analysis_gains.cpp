// Gains: what ST's generator computes from the same numbers, what rounding costs, and what a loop does with them.
#include "motor/current_loop.h"
#include "motor/fixed_point.h"
#include "motor/smaller_loops.h"
#include "motor/speed_loop.h"
#include "simulation/maths/gains.h"
#include "support/near.h"

#include <QTest>

#include <cmath>
#include <limits>

using support::nearByShare;
using namespace motor;

class TestAnalysisGains : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theWorkedExampleOfTheDocumentationComesOut();
    void aGeneratedProjectIsReproduced();
    void theRealLoopIsFasterThanTheRule();
    void theFinestDivisorKeepsTheNumeratorInRange_data();
    void theFinestDivisorKeepsTheNumeratorInRange();
    void whatDoesNotFitIsNamed();
    void aSlowLoopRisesLikeAFirstOrderOne();
    void delayShortensTheRiseAndThenOvershoots();
    void theSymmetricalOptimumHardlyOvershootsBehindItsFilter_data();
    void theSymmetricalOptimumHardlyOvershootsBehindItsFilter();
    void speedGainsCrossWhereTheyShould();
    void speedDigitsTurnIntoGainsAndBack();
    void observerGainsAreThoseOfTheGeneratedProject();
    void thePllIsAsItWasDesigned();
    void smallLoopsHaveTheirUnits();
    void anUnstableLoopStaysFinite();
};

namespace {

constexpr double kDigitsPerAmp = 65536.0 * 3e-3 * 9.14 / 3.3; // 3 mOhm, amplified 9.14 times
const PowerStage kStage{24.0, kDigitsPerAmp, 1.0 / 16000.0};

} // namespace

void TestAnalysisGains::theWorkedExampleOfTheDocumentationComesOut()
{
    QVERIFY(nearByShare(kDigitsPerAmp, 544.54, 1e-5));
    QVERIFY(nearByShare(kStage.ruleOhms(), 0.199418, 1e-5));
    const CurrentPlant plant{0.35, 0.6e-3};
    const PiGains digits = currentDigits(currentGains(plant, 1500.0), kStage);
    QVERIFY(nearByShare(digits.kp, 4.51313, 1e-5));
    QVERIFY(nearByShare(digits.ki, 0.164541, 1e-5));
    const Quantised kp = quantise(digits.kp, 10), ki = quantise(digits.ki, 14);
    QVERIFY((kp.gain == FixedPointGain{4621, 10}));
    QVERIFY((ki.gain == FixedPointGain{2696, 14}));
    QVERIFY(std::abs(kp.error) < 1.1e-4 && std::abs(ki.error) < 1e-4);
    QVERIFY(kp.problem == FixedPointProblem::None);
    QVERIFY(nearByShare(kp.numeratorMargin, 32767.0 / 4621.0, 1e-12));
    QVERIFY(nearByShare(ruleBandwidth_radps(kp.gain.value(), plant, kStage), 1500.0, 1.1e-4));
}

void TestAnalysisGains::aGeneratedProjectIsReproduced()
{
    // A published project: 0.03 Ohm, Lq 0.117 mH, Ld/Lq 0.597, generated for 6000 rad/s.
    const CurrentPlant q{0.03, 0.117e-3}, d{0.03, 0.117e-3 * 0.597};
    const PiGains torque = currentDigits(currentGains(q, 6000.0), kStage);
    const PiGains flux = currentDigits(currentGains(d, 6000.0), kStage);
    QVERIFY(nearByShare(quantise(torque.kp, 10).gain.numerator, 3614, 0.003));
    QVERIFY(nearByShare(quantise(torque.ki, 14).gain.numerator, 925, 0.003));
    QVERIFY(nearByShare(quantise(flux.kp, 10).gain.numerator, 2158, 0.003));
    QCOMPARE(torque.ki, flux.ki); // the resistance is the same
    QVERIFY(nearByShare(ruleBandwidth_radps(3614.0 / 1024.0, q, kStage), 6015.0, 1e-3));
}

void TestAnalysisGains::theRealLoopIsFasterThanTheRule()
{
    const CurrentPlant plant{0.35, 0.6e-3};
    const double kp = currentDigits(currentGains(plant, 1500.0), kStage).kp;
    // 2^16 digits of the bus against 32767 of Vbus / sqrt(3)
    QVERIFY(
        nearByShare(realBandwidth_radps(kp, plant, kStage), 1500.0 * 2.0 / std::sqrt(3.0), 1e-4));
    QCOMPARE(bandwidthLimit_radps(16000.0), 9600.0);
}

void TestAnalysisGains::theFinestDivisorKeepsTheNumeratorInRange_data()
{
    QTest::addColumn<double>("gain");
    QTest::addColumn<int>("numerator");
    QTest::addColumn<int>("exponent");
    QTest::newRow("Kp of the example") << 4.51313 << 18486 << 12;
    QTest::newRow("Ki of the example") << 0.164541 << 5392 << 15;
    QTest::newRow("one") << 1.0 << 16384 << 14;
    QTest::newRow("the largest") << 32767.0 << 32767 << 0;
    QTest::newRow("negative") << -1.488 << -24379 << 14;
    QTest::newRow("nothing") << 0.0 << 0 << 15;
}

void TestAnalysisGains::theFinestDivisorKeepsTheNumeratorInRange()
{
    QFETCH(double, gain);
    const Quantised quantised = quantiseFinely(gain);
    QVERIFY(quantised.problem == FixedPointProblem::None);
    QTEST(quantised.gain.numerator, "numerator");
    QTEST(quantised.gain.exponent, "exponent");
    QVERIFY(quantised.numeratorMargin >= 1.0 && quantised.productMargin > 1.0);
}

void TestAnalysisGains::whatDoesNotFitIsNamed()
{
    const Quantised large = quantise(4.5, 13);
    QVERIFY(large.problem == FixedPointProblem::NumeratorTooLarge);
    QCOMPARE(large.gain.numerator, 32767);
    QVERIFY(large.numeratorMargin < 1.0);
    QVERIFY(quantiseFinely(40000.0).problem == FixedPointProblem::NumeratorTooLarge);
    QVERIFY(quantise(1e-4, 10).problem == FixedPointProblem::RoundsToZero);
    QVERIFY(quantise(3.0, 10, 1e6).problem == FixedPointProblem::ProductTooLarge);
    QVERIFY(quantiseFinely(3.0, 1e6).gain.exponent < 10);
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL}) {
        const Quantised quantised = quantiseFinely(bad);
        QVERIFY(quantised.problem == FixedPointProblem::NotFinite);
        QCOMPARE(quantised.gain.numerator, 0);
    }
    QCOMPARE(quantise(1.0, 99).gain.exponent, kMaxExponent);
    QCOMPARE(quantise(1.0, -1).gain.exponent, 0);
}

void TestAnalysisGains::aSlowLoopRisesLikeAFirstOrderOne()
{
    const CurrentPlant plant{0.35, 0.6e-3};
    const double asked = 200.0;
    const PiGains digits = currentDigits(currentGains(plant, asked), kStage);
    const StepPrediction step = predictCurrentStep(digits, plant, kStage, 2000);
    const double real = realBandwidth_radps(digits.kp, plant, kStage);
    QVERIFY(nearByShare(step.rise_s, std::log(9.0) / real, 0.03));
    QVERIFY(step.overshoot < 1e-6);
    QVERIFY(nearByShare(step.response.back(), 1.0, 1e-6));
    QCOMPARE(step.response.front(), 0.0);
}

void TestAnalysisGains::delayShortensTheRiseAndThenOvershoots()
{
    const CurrentPlant plant{0.35, 0.6e-3};
    auto acting = Acting::Prompt;
    const auto stepOf = [&](double bandwidth) {
        const PiGains digits = currentDigits(currentGains(plant, bandwidth), kStage);
        return predictCurrentStep(digits, plant, kStage, 400, acting);
    };
    const StepPrediction prompt = stepOf(1500.0);
    QVERIFY(stepOf(9000.0).overshoot < 0.01); // only delay makes a cancelled pole overshoot
    acting = Acting::Late;
    const StepPrediction calm = stepOf(1500.0), quick = stepOf(9000.0);
    QVERIFY(calm.rise_s < prompt.rise_s);
    const double undelayed = std::log(9.0) / (1500.0 * 2 / std::sqrt(3.0));
    QVERIFY(nearByShare(prompt.rise_s, undelayed, 0.07));
    QVERIFY(calm.rise_s < undelayed);
    QVERIFY(calm.overshoot < 0.01);
    QVERIFY(quick.overshoot > 0.1);
    QVERIFY(quick.rise_s < calm.rise_s);
    // Nothing in, nothing out: no rise is made up.
    QCOMPARE(predictCurrentStep({0.0, 0.0}, plant, kStage, 100).rise_s, 0.0);
    QVERIFY(predictCurrentStep({4.5, 0.16}, {0.0, 0.6e-3}, kStage, 100).rise_s > 0.0);
}

void TestAnalysisGains::theSymmetricalOptimumHardlyOvershootsBehindItsFilter_data()
{
    QTest::addColumn<double>("damping");
    QTest::newRow("2") << 2.0;
    QTest::newRow("2.41") << 2.41;
    QTest::newRow("3") << 3.0;
    QTest::newRow("4") << 4.0;
    QTest::newRow("6") << 6.0;
}

void TestAnalysisGains::theSymmetricalOptimumHardlyOvershootsBehindItsFilter()
{
    QFETCH(double, damping);
    QVERIFY(filteredStepOvershoot(damping) < 0.09);
}

void TestAnalysisGains::speedGainsCrossWhereTheyShould()
{
    const SpeedPlant plant{0.039, 5e-5};
    const double lag = speedLoopLag_s(1500.0, 0.0, 1.0 / 16000.0, 1e-3);
    QVERIFY(nearByShare(lag, 1 / 1500.0 + 1.5 / 16000.0 + 0.5e-3, 1e-12));
    const double d = 3.0;
    const PiGains gains = speedGains(plant, lag, d);
    // The open loop has magnitude 1 at 1 / (d tau): |Kp + Ki/(jw)| K / w / |1 + jw tau|
    const double w = 1.0 / (d * lag), k = plant.kt_nmpa / plant.inertia_kgm2;
    const double magnitude = std::hypot(gains.kp, gains.ki / w) * k / w / std::hypot(1.0, w * lag);
    QVERIFY(nearByShare(magnitude, 1.0, 1e-9));
}

void TestAnalysisGains::speedDigitsTurnIntoGainsAndBack()
{
    const PiGains gains{0.05, 2.0};
    const PiGains digits = speedDigits(gains, kDigitsPerAmp, 1e-3);
    QVERIFY(nearByShare(digits.kp, 0.05 * 0.2 * M_PI * kDigitsPerAmp, 1e-12));
    QVERIFY(nearByShare(digits.ki, 2.0 * 0.2 * M_PI * kDigitsPerAmp * 1e-3, 1e-12));
    const PiGains back = speedGainsOf(digits, kDigitsPerAmp, 1e-3);
    QVERIFY(nearByShare(back.kp, gains.kp, 1e-12) && nearByShare(back.ki, gains.ki, 1e-12));
}

void TestAnalysisGains::observerGainsAreThoseOfTheGeneratedProject()
{
    ObserverScale scale;
    scale.maxCurrent_a = 32768.0 / kDigitsPerAmp;
    scale.maxBemf_v = maxObserverBemf_v(33000.0, 0.9);
    QCOMPARE(scale.maxBemf_v, 29.0);
    const ObserverGains gains = observerGains({0.03, 0.117e-3}, 1.0 / 16000.0, scale);
    QCOMPARE(std::trunc(gains.gain1), -24379.0);
    QVERIFY(nearByShare(gains.gain1, -24379.08, 1e-6));
    QVERIFY(nearByShare(gains.gain2, 18041.0, 0.003));
}

void TestAnalysisGains::thePllIsAsItWasDesigned()
{
    // Designed by the simulated board's own rule: 400 rad/s, critically damped at half the highest speed.
    const simulation::Pi::Gains pll =
        simulation::pllGains(400.0, 1.0, 32767.0 * 0.5 / 1.2, 16000.0);
    const PiGains digits{std::ldexp(pll.kp, -pll.kpShift), std::ldexp(pll.ki, -pll.kiShift)};
    const PllForecast half = pllForecast(digits, 1.0 / 16000.0, 0.5);
    // Its Ki has two digits.
    QVERIFY(nearByShare(half.natural_radps, 400.0, 0.02));
    QVERIFY(nearByShare(half.damping, 1.0, 0.02));
    QVERIFY(nearByShare(pllForecast(digits, 1.0 / 16000.0, 0.125).natural_radps, 200.0, 0.02));
    QCOMPARE(pllForecast({1.0, 0.0}, 1.0 / 16000.0, 0.5).damping, 0.0);
}

void TestAnalysisGains::smallLoopsHaveTheirUnits()
{
    // A volt is 32767 sqrt(3) / 24 digits, an ampere 544.5.
    const PiGains weakening = fluxWeakeningGains({1.0, 0.5}, kStage, 1e-3);
    QVERIFY(nearByShare(weakening.kp, 32767.0 * std::sqrt(3.0) / 24.0 / kDigitsPerAmp, 1e-9));
    QVERIFY(nearByShare(weakening.ki, 500.0 * weakening.kp, 1e-9));
    const PidGains position = positionGains({1.0, 1.0, 1.0}, kStage, 1e-3);
    QVERIFY(nearByShare(position.kp, 65536.0 / (2.0 * M_PI) / kDigitsPerAmp, 1e-9));
    QVERIFY(nearByShare(position.ki, 1000.0 * position.kp, 1e-9));
    QVERIFY(nearByShare(position.kd, position.kp / 1000.0, 1e-9));
}

void TestAnalysisGains::anUnstableLoopStaysFinite()
{
    const StepPrediction current = predictCurrentStep({200.0, 1.0}, {0.35, 0.6e-3}, kStage, 100000);
    const StepPrediction speed =
        predictSpeedStep({1e-3, 50.0}, {0.039, 5e-5}, {3e-3, 0.0}, 10.0, 10000);
    for (const StepPrediction &step : {current, speed}) {
        QVERIFY(step.overshoot > 10.0);
        for (const double value : step.response)
            QVERIFY(std::abs(value) <= 1e3);
    }
    QVERIFY(speedMargin({1e-3, 50.0}, {0.039, 5e-5}, 3e-3).phase_deg < 0.0);
}

QTEST_APPLESS_MAIN(TestAnalysisGains)
#include "tst_analysis_gains.moc"
