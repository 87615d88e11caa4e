// The current loops with ST's gains on a locked rotor: as fast as their bandwidth says, without overshoot; and what
// becomes of it with other gains. Source of the vectors and of 2.2/wc: features 6.2.
//
// ST's rule counts a digit of voltage as bus / 65536. The modulation makes bus / (sqrt(3) 32768) of it, 2 / sqrt(3) as
// much (mcp-aspep section 9), so that gains for wc give a loop of 1.155 wc: the vector for 1500 rad/s gives 1732.
#include "simulation/firmware/current_control.h"
#include "simulation/firmware/design.h"
#include "simulation/plant/plant.h"
#include "simulation/plant/presets.h"
#include "support/axis_bench.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <vector>

using namespace simulation;

namespace {

constexpr double kHf_hz = 16000.0, kBandwidth_radps = 1500.0;
constexpr double kVoltageGain = 2.0 / std::numbers::sqrt3; ///< modulation against the rule

/// The first preset is the motor of the test vector: 0.35 ohm, 0.6 mH, 24 V, 3 mohm, 9.14. Its rotor is held.
PlantParameters held(bool ideal)
{
    PlantParameters p = presets().front().parameters;
    p.motor.coulomb_nm = 1000.0;
    if (ideal) { // nothing but R, L and the converters' steps
        p.inverter.deadTime_s = 0.0;
        p.inverter.noise_digits = 0.0;
        p.inverter.switchResistance_ohm = 0.0;
        p.inverter.supplyResistance_ohm = 1e-4;
        p.motor.copperMass_kg = 0.0;
    }
    return p;
}

struct StepResponse {
    double rise_s = 0.0, overshoot = 0.0, end = 0.0, ripple = 0.0;
};

enum class Along { Q, D };

/// A step of `digits` at rest, measured as the firmware sees it; 10 % to 90 % between samples.
StepResponse step(
    const PlantParameters &parameters, const Tuning &tuning, Along axis, double digits)
{
    Plant plant(parameters, 1);
    CurrentControl control(5312);
    Signals seenBy;
    std::vector<double> seen;
    const auto angle = static_cast<std::int16_t>(std::lround(
        std::remainder(plant.angle_rad(), 2.0 * std::numbers::pi) * 32767.0 / std::numbers::pi));
    const auto period = [&](std::int16_t reference) {
        plant.advance(1.0 / kHf_hz);
        const Ab currents{saturateSymmetric(32768 - plant.currentA()),
            saturateSymmetric(32768 - plant.currentB())};
        const Qd wanted = axis == Along::Q ? Qd{reference, 0} : Qd{0, reference};
        const Duties d = control.step(currents, {angle, 0}, wanted, {}, tuning, seenBy);
        plant.setBridge({true, d.a, d.b, d.c});
        seen.push_back(axis == Along::Q ? seenBy.iQ : seenBy.iD);
    };
    for (int i = 0; i < 200; ++i)
        period(0);
    seen.clear();
    for (int i = 0; i < 800; ++i)
        period(static_cast<std::int16_t>(digits));
    StepResponse out;
    double most = 0.0, least = 1e9;
    for (std::size_t i = 600; i < seen.size(); ++i) {
        out.end += seen[i] / 200.0;
        most = std::max(most, seen[i]);
        least = std::min(least, seen[i]);
    }
    out.ripple = (most - least) / digits;
    const auto crosses = [&](double level) {
        for (std::size_t i = 1; i < seen.size(); ++i)
            if (seen[i] >= level)
                return (static_cast<double>(i) - (seen[i] - level) / (seen[i] - seen[i - 1]))
                    / kHf_hz;
        return 1e9;
    };
    out.rise_s = crosses(0.9 * out.end) - crosses(0.1 * out.end);
    double top = 0.0;
    for (const double value : seen)
        top = std::max(top, value);
    out.overshoot = (top - out.end) / out.end;
    return out;
}

} // namespace

class TestFirmwareCurrentLoop : public QObject {
    Q_OBJECT

private slots:
    void theDesignIsTheTestVector();
    void theLoopRisesAsItsBandwidthSays_data();
    void theLoopRisesAsItsBandwidthSays();
    void deadTimeAndNoiseDoNotSpoilIt();
    void twentyTimesTheGainOscillates();
    void twiceTheVoltageNeededIsCutNotWound();
};

void TestFirmwareCurrentLoop::theDesignIsTheTestVector()
{
    const DriveDesign design = support::usualDesign(presets().front().parameters, kHf_hz);
    QCOMPARE(design.tuning.qKp, std::int16_t{4621});
    QCOMPARE(design.tuning.qKpDiv, std::int16_t{10});
    QCOMPARE(design.tuning.qKi, std::int16_t{2696});
    QCOMPARE(design.tuning.qKiDiv, std::int16_t{14});
    QCOMPARE(design.tuning.dKp, design.tuning.qKp);
}

void TestFirmwareCurrentLoop::theLoopRisesAsItsBandwidthSays_data()
{
    QTest::addColumn<bool>("q");
    QTest::addColumn<double>("asked_radps");
    QTest::addColumn<double>("digits");
    QTest::newRow("the vector, q, 1000 digits") << true << kBandwidth_radps << 1000.0;
    QTest::newRow("the vector, q, 2700 digits") << true << kBandwidth_radps << 2700.0;
    QTest::newRow("the vector, d, 1000 digits") << false << kBandwidth_radps << 1000.0;
    QTest::newRow("1500 rad/s, q, 1000 digits")
        << true << kBandwidth_radps / kVoltageGain << 1000.0;
    QTest::newRow("1500 rad/s, d, 2700 digits")
        << false << kBandwidth_radps / kVoltageGain << 2700.0;
    QTest::newRow("700 rad/s, q, 1000 digits") << true << 700.0 / kVoltageGain << 1000.0;
}

void TestFirmwareCurrentLoop::theLoopRisesAsItsBandwidthSays()
{
    QFETCH(bool, q);
    QFETCH(double, asked_radps);
    QFETCH(double, digits);
    const PlantParameters plant = held(true);
    Tuning tuning = support::usualDesign(plant, kHf_hz).tuning;
    const Pi::Gains gains =
        currentGains(plant.motor.lq_h, plant.motor.rs_ohm, asked_radps, sensingOf(plant), kHf_hz);
    tuning.qKp = tuning.dKp = gains.kp;
    tuning.qKi = tuning.dKi = gains.ki;
    QCOMPARE(gains.kpShift, 10);
    QCOMPARE(gains.kiShift, 14);
    const StepResponse seen = step(plant, tuning, q ? Along::Q : Along::D, digits);
    const double expected_s = 2.2 / (asked_radps * kVoltageGain);
    QVERIFY2(std::abs(seen.rise_s - expected_s) < 0.1 * expected_s,
        qPrintable(QString::number(seen.rise_s * 1e3)));
    QVERIFY2(seen.overshoot < 0.05, qPrintable(QString::number(seen.overshoot)));
    QVERIFY(std::abs(seen.end - digits) < 0.01 * digits);
}

void TestFirmwareCurrentLoop::deadTimeAndNoiseDoNotSpoilIt()
{
    // Near no current, dead time takes voltage as a resistance would: it is slower from there.
    const PlantParameters plant = held(false);
    const StepResponse seen =
        step(plant, support::usualDesign(plant, kHf_hz).tuning, Along::Q, 2000.0);
    const double expected_s = 2.2 / (kBandwidth_radps * kVoltageGain);
    QVERIFY2(seen.rise_s > 0.9 * expected_s && seen.rise_s < 1.5 * expected_s,
        qPrintable(QString::number(seen.rise_s * 1e3)));
    QVERIFY2(seen.overshoot < 0.05, qPrintable(QString::number(seen.overshoot)));
}

void TestFirmwareCurrentLoop::twentyTimesTheGainOscillates()
{
    const PlantParameters plant = held(true);
    Tuning tuning = support::usualDesign(plant, kHf_hz).tuning;
    const double calm = step(plant, tuning, Along::Q, 1000.0).ripple;
    tuning.qKpDiv = 5; // 32 times: far beyond what the delay allows
    const double wild = step(plant, tuning, Along::Q, 1000.0).ripple;
    QVERIFY2(calm < 0.02 && wild > 0.3,
        qPrintable(QString::number(calm) + QStringLiteral(" ") + QString::number(wild)));
}

void TestFirmwareCurrentLoop::twiceTheVoltageNeededIsCutNotWound()
{
    // 40 A into 0.35 ohm are 14 V, the bridge has 13.86: the reference is never reached, and left without delay.
    const PlantParameters plant = held(true);
    const StepResponse seen =
        step(plant, support::usualDesign(plant, kHf_hz).tuning, Along::Q, 26000.0);
    const double most_a = 24.0 / std::numbers::sqrt3 / 0.35;
    const double end_a = seen.end / plant.inverter.digitsPerAmp();
    QVERIFY2(std::abs(end_a - most_a) < 0.03 * most_a, qPrintable(QString::number(end_a)));
    QVERIFY(seen.overshoot < 0.01);
}

QTEST_APPLESS_MAIN(TestFirmwareCurrentLoop)
#include "tst_firmware_current_loop.moc"
