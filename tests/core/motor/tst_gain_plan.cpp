// The plan of a board's gains: ST's numbers, what the loops will do with them, and what is said about plans that are
// no good. And what a board says as the plan's plant.
#include "drive/motor_view.h"
#include "motor/gain_plan.h"
#include "support/near.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using support::nearByShare;
using namespace motor;

namespace {

GainPlant vectorPlant()
{
    GainPlant plant;
    plant.motor = {.polePairs = 4,
        .rs_ohm = 0.35,
        .lq_h = 0.6e-3,
        .ld_h = 0.6e-3,
        .flux_wb = 6.5e-3,
        .nominalCurrent_a = 5.0};
    plant.inertia_kgm2 = 5e-5;
    plant.stage = {24.0, 65536.0 * 3e-3 * 9.14 / 3.3, 1.0 / 16000.0};
    plant.speedPeriod_s = 1e-3;
    plant.speedDelay_s = 2e-3;
    return plant;
}

constexpr PerGain<std::optional<int>> kStsDivisors{10, 14, 10, 14, 9, 14};

bool says(const GainPlan &plan, GainWarning warning)
{
    return std::any_of(plan.findings.begin(), plan.findings.end(),
        [warning](const GainFinding &finding) { return finding.warning == warning; });
}

} // namespace

class TestGainPlan : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void stsNumbersComeOutWithItsDivisors()
    {
        const GainPlan plan = planGains(vectorPlant(), {1500.0, 0.0}, kStsDivisors);
        QVERIFY(!plan.blocked());
        QCOMPARE(plan.gains.size(), 4U);
        QVERIFY((plan.find(GainId::TorqueKp)->quantised.gain == FixedPointGain{4621, 10}));
        QVERIFY((plan.find(GainId::FluxKi)->quantised.gain == FixedPointGain{2696, 14}));
        QVERIFY(nearByShare(plan.find(GainId::TorqueKp)->asked, 0.9, 1e-12)); // Ls w
        QVERIFY(nearByShare(plan.find(GainId::TorqueKp)->real, 0.9 * 2.0 / std::sqrt(3.0), 2e-4));
        QVERIFY(nearByShare(plan.current->ruleBandwidth_radps, 1500.0, 2e-4));
        QVERIFY(nearByShare(plan.current->realBandwidth_radps, 1732.0, 1e-3));
        QVERIFY(!plan.speed && plan.find(GainId::SpeedKp) == nullptr);
    }

    void theSecondVectorComesOutWithinThreePerMille()
    {
        GainPlant plant = vectorPlant();
        plant.motor.rs_ohm = 0.03;
        plant.motor.lq_h = 0.117e-3;
        plant.motor.ld_h = 0.117e-3 * 0.597;
        const GainPlan plan = planGains(plant, {6000.0, 0.0}, kStsDivisors);
        QVERIFY(nearByShare(plan.find(GainId::TorqueKp)->quantised.gain.numerator, 3614, 0.003));
        QVERIFY(nearByShare(plan.find(GainId::TorqueKi)->quantised.gain.numerator, 925, 0.003));
        QVERIFY(nearByShare(plan.find(GainId::FluxKp)->quantised.gain.numerator, 2158, 0.003));
    }

    void aDivisorThatServesIsKeptAndOthersAreNot()
    {
        PerGain<std::optional<int>> divisors = kStsDivisors;
        divisors[indexOf(GainId::TorqueKp)] = 15; // 4.5 does not fit
        divisors[indexOf(GainId::TorqueKi)] = 6; // 10.5 / 64: 4 % of rounding
        divisors[indexOf(GainId::FluxKp)] = std::nullopt;
        const GainPlan plan = planGains(vectorPlant(), {1500.0, 0.0}, divisors);
        QCOMPARE(plan.find(GainId::TorqueKp)->quantised.gain.exponent, 12);
        QCOMPARE(plan.find(GainId::TorqueKi)->quantised.gain.exponent, 15);
        QCOMPARE(plan.find(GainId::FluxKp)->quantised.gain.exponent, 12);
        QCOMPARE(plan.find(GainId::FluxKi)->quantised.gain.exponent, 14);
        for (const PlannedGain &gain : plan.gains)
            QVERIFY(std::abs(gain.quantised.error) < 1e-3);
    }

    void theSpeedLoopHasTheMarginOfItsDamping_data()
    {
        QTest::addColumn<double>("damping");
        QTest::addColumn<double>("margin_deg");
        QTest::addColumn<double>("overshoot");
        QTest::newRow("2") << 2.0 << 36.9 << 0.43;
        QTest::newRow("2.41") << 2.41 << 45.0 << 0.34;
        QTest::newRow("3") << 3.0 << 53.1 << 0.25;
        QTest::newRow("4") << 4.0 << 61.9 << 0.17;
        QTest::newRow("6") << 6.0 << 71.1 << 0.11;
    }
    void theSpeedLoopHasTheMarginOfItsDamping()
    {
        QFETCH(double, damping);
        QFETCH(double, margin_deg);
        QFETCH(double, overshoot);
        const GainPlant plant = vectorPlant();
        const GainPlan plan = planGains(plant, {1500.0, damping}, kStsDivisors);
        QCOMPARE(plan.gains.size(), 6U);
        const double lag = 1.0 / plan.current->realBandwidth_radps + 2e-3 + 1.5 / 16000.0 + 0.5e-3;
        QVERIFY(nearByShare(plan.speed->lag_s, lag, 1e-12));
        QVERIFY(nearByShare(plan.speed->margin.crossover_radps, 1.0 / (damping * lag), 0.01));
        QVERIFY(std::abs(plan.speed->margin.phase_deg - margin_deg) < 0.3);
        // The rule takes the average of the speed for a lag. As the delay that it is, it lets a loop near its limit
        // ring more.
        const double more = plan.speed->step.overshoot - overshoot;
        QVERIFY(more > -0.01 && more < (damping < 2.41 ? 0.06 : 0.01));
        QVERIFY(plan.speed->step.rise_s > lag && plan.speed->step.rise_s < 3 * damping * lag);
        QVERIFY(nearByShare(plan.speed->step.response.back(), 1.0, 0.06));
        QCOMPARE(says(plan, GainWarning::SpeedMarginSmall), plan.speed->margin.phase_deg < 45.0);
        QVERIFY(plan.rampedOvershoot < 0.09);
        // Kp times the largest step is the nominal current.
        const double radps = plan.speed->largestStep_rpm * M_PI / 30.0;
        QVERIFY(nearByShare(radps * plan.find(GainId::SpeedKp)->real, 5.0, 1e-9));
    }

    void whatIsMissingIsNamed()
    {
        GainPlant plant = vectorPlant();
        plant.inertia_kgm2 = 0.0;
        plant.motor.flux_wb = NAN;
        plant.speedPeriod_s = 0.0;
        GainPlan plan = planGains(plant, {1500.0, 3.0}, kStsDivisors);
        QVERIFY(!plan.blocked() && plan.gains.size() == 4 && !plan.speed);
        QVERIFY(says(plan, GainWarning::SpeedNeedsFlux)
            && says(plan, GainWarning::SpeedNeedsInertia)
            && says(plan, GainWarning::SpeedNeedsPeriod));
        plant = vectorPlant();
        plant.motor.rs_ohm = 0.0;
        plant.stage = {};
        plan = planGains(plant, {1500.0, 3.0}, kStsDivisors);
        QVERIFY(plan.blocked() && plan.gains.empty() && !plan.current);
        QVERIFY(says(plan, GainWarning::MotorMissing) && says(plan, GainWarning::ScaleMissing)
            && says(plan, GainWarning::PeriodMissing));
    }

    void plansThatMustNotBeWrittenAreBlocked_data()
    {
        QTest::addColumn<double>("rs");
        QTest::addColumn<double>("inductance");
        QTest::addColumn<double>("bandwidth");
        QTest::addColumn<int>("warning");
        QTest::newRow("too quick")
            << 0.35 << 0.6e-3 << 9700.0 << int(GainWarning::BandwidthBeyondLimit);
        QTest::newRow("not a number")
            << 0.35 << 0.6e-3 << double(NAN) << int(GainWarning::BandwidthBeyondLimit);
        QTest::newRow("a huge coil") << 0.35 << 10.0 << 9000.0 << int(GainWarning::DoesNotFit);
        QTest::newRow("no resistance to speak of")
            << 1e-6 << 0.6e-3 << 10.0 << int(GainWarning::RoundsToZero);
    }
    void plansThatMustNotBeWrittenAreBlocked()
    {
        QFETCH(double, rs);
        QFETCH(double, inductance);
        QFETCH(double, bandwidth);
        QFETCH(int, warning);
        GainPlant plant = vectorPlant();
        plant.motor.rs_ohm = rs;
        plant.motor.lq_h = plant.motor.ld_h = inductance;
        const GainPlan plan = planGains(plant, {bandwidth, 0.0}, kStsDivisors);
        QVERIFY(plan.blocked());
        QVERIFY(says(plan, static_cast<GainWarning>(warning)));
    }

    void whatIsWorthKnowingIsSaidAndDoesNotBlock()
    {
        GainPlant plant = vectorPlant();
        plant.bandwidthGuide_radps = 4500.0;
        plant.motor.ld_h = 0.7e-3;
        const GainPlan plan = planGains(plant, {8000.0, 0.0}, kStsDivisors);
        QVERIFY(!plan.blocked());
        QVERIFY(says(plan, GainWarning::BandwidthBeyondGuide)
            && says(plan, GainWarning::CurrentMarginSmall) && says(plan, GainWarning::LdAboveLq));
        QVERIFY(plan.current->phaseMargin_deg > 35.0 && plan.current->phaseMargin_deg < 45.0);
        const GainPlan calm = planGains(vectorPlant(), {1500.0, 4.0}, kStsDivisors);
        QVERIFY(calm.findings.empty());
        QVERIFY(nearByShare(calm.current->phaseMargin_deg, 90.0 - 9.3, 0.002));
    }

    void digitsAreToldAsWhatTheyMakeAtTheMotor()
    {
        const GainPlant plant = vectorPlant();
        const double kp = 4621.0 / 1024.0;
        QVERIFY(nearByShare(*physicalGain(GainId::TorqueKp, kp, plant), 1.0392, 1e-3));
        QVERIFY(nearByShare(*physicalGain(GainId::TorqueKi, 2696.0 / 16384.0, plant), 606.2, 1e-3));
        QVERIFY(nearByShare(
            *physicalGain(GainId::SpeedKp, 100.0, plant), 100.0 / (0.2 * M_PI * 544.54), 1e-4));
        GainPlant bare;
        QVERIFY(!physicalGain(GainId::TorqueKp, kp, bare));
        QVERIFY(!physicalGain(GainId::SpeedKi, kp, bare));
        bare.stage = {24.0, 544.54, 0.0};
        QVERIFY(physicalGain(GainId::TorqueKp, kp, bare)); // needs no period
        QVERIFY(!physicalGain(GainId::TorqueKi, kp, bare));
    }

    void whatABoardSaysBecomesThePlant()
    {
        drive::MotorFacts facts;
        facts.motor = vectorPlant().motor;
        facts.bus_v = 24.0;
        facts.ampsPerDigit = 1.0 / vectorPlant().stage.digitsPerAmp;
        facts.controlPeriod_s = 1.0 / 16000.0;
        facts.speedPeriod_s = 1e-3;
        facts.speedDelay_s = 2e-3;
        facts.inertia_kgm2 = 5e-5;
        const GainPlan same = planGains(drive::gainPlant(facts), {1500.0, 4.0}, kStsDivisors);
        const GainPlan typed = planGains(vectorPlant(), {1500.0, 4.0}, kStsDivisors);
        for (const PlannedGain &gain : typed.gains)
            QVERIFY(same.find(gain.id)->quantised.gain == gain.quantised.gain);
        QVERIFY(planGains(drive::gainPlant({}), {1500.0, 4.0}, kStsDivisors).blocked());
    }
};

QTEST_APPLESS_MAIN(TestGainPlan)
#include "tst_gain_plan.moc"
