#include "motor/gain_plan.h"

#include <algorithm>
#include <cmath>

namespace motor {

namespace {

bool isSpeed(GainId id) { return id == GainId::SpeedKp || id == GainId::SpeedKi; }
bool isIntegral(GainId id)
{
    return id == GainId::TorqueKi || id == GainId::FluxKi || id == GainId::SpeedKi;
}

/// Digits of a speed gain of 1 [A/(rad/s)] or [A/rad].
double speedFactor(GainId id, const GainPlant &plant)
{
    const PiGains one = speedDigits({1.0, 1.0}, plant.stage.digitsPerAmp, plant.speedPeriod_s);
    return isIntegral(id) ? one.ki : one.kp;
}

class Planner {
public:
    Planner(
        const GainPlant &plant, const GainWish &wish, const PerGain<std::optional<int>> &divisors)
        : m_plant(plant)
        , m_wish(wish)
        , m_divisors(divisors)
    {
    }

    GainPlan plan()
    {
        if (hasCurrentPlant()) {
            planCurrents();
            if (m_wish.damping > 0.0 && hasSpeedPlant())
                planSpeed();
        }
        std::ranges::stable_sort(m_plan.findings, {}, &GainFinding::warning);
        return std::move(m_plan);
    }

private:
    void find(GainWarning warning, double is = 0.0, double limit = 0.0,
        std::optional<GainId> gain = std::nullopt)
    {
        m_plan.findings.push_back({warning, gain, is, limit});
    }
    bool need(bool is, GainWarning warning)
    {
        if (!is)
            find(warning);
        return is;
    }

    bool hasCurrentPlant()
    {
        const MotorParameters &m = m_plant.motor;
        const PowerStage &s = m_plant.stage;
        const bool motor =
            need(known(m.rs_ohm) && known(m.lq_h) && known(m.ld_h), GainWarning::MotorMissing);
        const bool scale = need(known(s.bus_v) && known(s.digitsPerAmp), GainWarning::ScaleMissing);
        const bool period = need(known(s.controlPeriod_s), GainWarning::PeriodMissing);
        return motor && scale && period;
    }

    bool hasSpeedPlant()
    {
        const bool flux = need(known(m_plant.speed().kt_nmpa), GainWarning::SpeedNeedsFlux);
        const bool inertia = need(known(m_plant.inertia_kgm2), GainWarning::SpeedNeedsInertia);
        const bool period = need(known(m_plant.speedPeriod_s), GainWarning::SpeedNeedsPeriod);
        return flux && inertia && period;
    }

    void add(GainId id, double asked, double digits)
    {
        const auto divisor = m_divisors[indexOf(id)];
        Quantised kept = divisor ? quantise(digits, *divisor) : quantiseFinely(digits);
        if (kept.problem != FixedPointProblem::None || std::abs(kept.error) > kFineRounding)
            kept = quantiseFinely(digits);
        const double real = physicalGain(id, kept.gain.value(), m_plant).value_or(0.0);
        m_plan.gains.push_back({id, asked, real, kept});
        if (kept.problem == FixedPointProblem::RoundsToZero)
            find(GainWarning::RoundsToZero, 0.0, 0.0, id);
        else if (kept.problem == FixedPointProblem::ProductTooLarge)
            find(GainWarning::ProductTooLarge, 0.0, 0.0, id);
        else if (kept.problem != FixedPointProblem::None)
            find(GainWarning::DoesNotFit, 0.0, 0.0, id);
        else if (std::abs(kept.error) > kCoarseRounding)
            find(GainWarning::CoarseRounding, kept.error, kCoarseRounding, id);
    }

    /// What the registers will hold; 0 where nothing fits.
    PiGains kept(GainId kp, GainId ki) const
    {
        return {m_plan.find(kp)->quantised.gain.value(), m_plan.find(ki)->quantised.gain.value()};
    }

    void planAxis(GainId kp, GainId ki, const CurrentPlant &axis)
    {
        const PiGains gains = currentGains(axis, m_wish.bandwidth_radps);
        const PiGains digits = currentDigits(gains, m_plant.stage);
        add(kp, gains.kp, digits.kp);
        add(ki, gains.ki, digits.ki);
    }

    void planCurrents()
    {
        const double bandwidth = m_wish.bandwidth_radps;
        const double limit = bandwidthLimit_radps(1.0 / m_plant.stage.controlPeriod_s);
        if (!(bandwidth <= limit))
            find(GainWarning::BandwidthBeyondLimit, bandwidth, limit);
        else if (known(m_plant.bandwidthGuide_radps) && bandwidth > m_plant.bandwidthGuide_radps)
            find(GainWarning::BandwidthBeyondGuide, bandwidth, m_plant.bandwidthGuide_radps);
        constexpr double kRounding = 1.001; // single precision and a ratio of three digits
        if (m_plant.motor.ld_h > m_plant.motor.lq_h * kRounding)
            find(GainWarning::LdAboveLq);
        planAxis(GainId::TorqueKp, GainId::TorqueKi, m_plant.torque());
        planAxis(GainId::FluxKp, GainId::FluxKi, m_plant.flux());
        const PiGains torque = kept(GainId::TorqueKp, GainId::TorqueKi);
        if (!known(torque.kp))
            return;
        m_plan.current = forecastCurrent(torque, m_plant.torque(), m_plant.stage);
        if (m_plan.current->phaseMargin_deg < kSmallMargin_deg)
            find(
                GainWarning::CurrentMarginSmall, m_plan.current->phaseMargin_deg, kSmallMargin_deg);
    }

    void planSpeed()
    {
        if (!m_plan.current)
            return;
        const double bandwidth = m_plan.current->realBandwidth_radps;
        const double lag = speedLoopLag_s(
            bandwidth, m_plant.speedDelay_s, m_plant.stage.controlPeriod_s, m_plant.speedPeriod_s);
        const PiGains gains = speedGains(m_plant.speed(), lag, m_wish.damping);
        const PiGains digits =
            speedDigits(gains, m_plant.stage.digitsPerAmp, m_plant.speedPeriod_s);
        add(GainId::SpeedKp, gains.kp, digits.kp);
        add(GainId::SpeedKi, gains.ki, digits.ki);
        const PiGains speed = kept(GainId::SpeedKp, GainId::SpeedKi);
        if (!known(speed.kp))
            return;
        m_plan.speed = forecastSpeed(speed, m_plant, bandwidth);
        m_plan.rampedOvershoot = filteredStepOvershoot(m_wish.damping);
        if (m_plan.speed->margin.phase_deg < kSmallMargin_deg)
            find(GainWarning::SpeedMarginSmall, m_plan.speed->margin.phase_deg, kSmallMargin_deg);
    }

    const GainPlant &m_plant;
    GainWish m_wish;
    const PerGain<std::optional<int>> &m_divisors;
    GainPlan m_plan;
};

} // namespace

CurrentForecast forecastCurrent(
    const PiGains &digits, const CurrentPlant &plant, const PowerStage &stage, double duration_s)
{
    constexpr double kTimeConstants = 10.0;
    constexpr int kMore = 20, kMostSamples = 5000;
    CurrentForecast forecast;
    forecast.ruleBandwidth_radps = ruleBandwidth_radps(digits.kp, plant, stage);
    forecast.realBandwidth_radps = realBandwidth_radps(digits.kp, plant, stage);
    forecast.phaseMargin_deg =
        currentPhaseMargin_deg(forecast.realBandwidth_radps, stage.controlPeriod_s);
    const double duration =
        duration_s > 0.0 ? duration_s : kTimeConstants / forecast.realBandwidth_radps;
    const double samples = std::min(duration / stage.controlPeriod_s, double{kMostSamples});
    const int count = static_cast<int>(samples) + kMore;
    forecast.step = predictCurrentStep(digits, plant, stage, count);
    forecast.lateOvershoot =
        predictCurrentStep(digits, plant, stage, count, Acting::Late).overshoot;
    return forecast;
}

SpeedForecast forecastSpeed(
    const PiGains &digits, const GainPlant &plant, double realBandwidth_radps, double duration_s)
{
    constexpr int kSamples = 600;
    constexpr double kRpmPerRadps = 9.5492965855137;
    SpeedForecast forecast;
    forecast.lag_s = speedLoopLag_s(
        realBandwidth_radps, plant.speedDelay_s, plant.stage.controlPeriod_s, plant.speedPeriod_s);
    const PiGains gains = speedGainsOf(digits, plant.stage.digitsPerAmp, plant.speedPeriod_s);
    forecast.margin = speedMargin(gains, plant.speed(), forecast.lag_s);
    // From the step to the end of its tail: some turns of the crossover, and of the regulator's zero.
    const double zero_s = gains.ki > 0.0 ? gains.kp / gains.ki : 0.0;
    const double natural_s = std::max(12.0 / forecast.margin.crossover_radps, 4.0 * zero_s);
    const SpeedPath path{forecast.lag_s - plant.speedDelay_s, 2.0 * plant.speedDelay_s};
    forecast.step = predictSpeedStep(
        gains, plant.speed(), path, duration_s > 0.0 ? duration_s : natural_s, kSamples);
    if (known(plant.motor.nominalCurrent_a))
        forecast.largestStep_rpm = plant.motor.nominalCurrent_a / gains.kp * kRpmPerRadps;
    return forecast;
}

bool GainPlan::blocked() const
{
    return std::ranges::any_of(
        findings, [](const GainFinding &finding) { return blocks(finding.warning); });
}

const PlannedGain *GainPlan::find(GainId id) const
{
    const auto found = std::ranges::find(gains, id, &PlannedGain::id);
    return found == gains.end() ? nullptr : &*found;
}

GainPlan planGains(
    const GainPlant &plant, const GainWish &wish, const PerGain<std::optional<int>> &divisors)
{
    return Planner(plant, wish, divisors).plan();
}

std::optional<double> physicalGain(GainId id, double digits, const GainPlant &plant)
{
    if (isSpeed(id)) {
        if (!known(plant.stage.digitsPerAmp) || (isIntegral(id) && !known(plant.speedPeriod_s)))
            return std::nullopt;
        return digits / speedFactor(id, plant);
    }
    if (!known(plant.stage.bus_v) || !known(plant.stage.digitsPerAmp)
        || (isIntegral(id) && !known(plant.stage.controlPeriod_s)))
        return std::nullopt;
    const double physical = digits * plant.stage.realOhms();
    return isIntegral(id) ? physical / plant.stage.controlPeriod_s : physical;
}

} // namespace motor
