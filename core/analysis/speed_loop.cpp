#include "analysis/speed_loop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace analysis {

namespace {

constexpr double kRadpsPerDigit = 2.0 * std::numbers::pi / 10.0; // 0.1 Hz

/// The closed loop in units of its lag: with tau = 1 only the damping is left.
class NormalLoop {
public:
    NormalLoop(double damping, bool filtered)
        : m_kp(1.0 / damping)
        , m_ki(1.0 / (damping * damping * damping))
        , m_filterRate(filtered ? 1.0 / (damping * damping) : 0.0)
        , m_state{filtered ? 0.0 : 1.0, 0.0, 0.0, 0.0}
    {
    }

    void step(double h)
    {
        const State a = slope(m_state), b = slope(moved(a, h / 2)), c = slope(moved(b, h / 2)),
                    d = slope(moved(c, h));
        for (std::size_t i = 0; i < m_state.size(); ++i)
            m_state[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    }
    double speed() const { return m_state[3]; }

private:
    using State = std::array<double, 4>; ///< reference, integral, lagged current, speed

    State slope(const State &at) const
    {
        const double error = at[0] - at[3];
        return {m_filterRate * (1.0 - at[0]), m_ki * error, m_kp * error + at[1] - at[2], at[2]};
    }
    State moved(const State &slope, double h) const
    {
        State to = m_state;
        for (std::size_t i = 0; i < to.size(); ++i)
            to[i] += h * slope[i];
        return to;
    }

    double m_kp, m_ki, m_filterRate;
    State m_state;
};

double overshoot(double damping, bool filtered)
{
    constexpr double kStep = 0.02;
    const double end = 12.0 * damping * damping; // the peak comes before
    NormalLoop loop(damping, filtered);
    double peak = 0.0;
    for (double t = 0.0; t < end; t += kStep) {
        loop.step(kStep);
        peak = std::max(peak, loop.speed());
    }
    return std::max(0.0, peak - 1.0);
}

} // namespace

double speedLoopLag_s(
    double currentBandwidth_radps, double filter_s, double controlPeriod_s, double speedPeriod_s)
{
    return 1.0 / currentBandwidth_radps + filter_s + 1.5 * controlPeriod_s + speedPeriod_s / 2.0;
}

PiGains speedGains(const SpeedPlant &plant, double lag_s, double damping)
{
    const double perAmp = plant.kt_nmpa / plant.inertia_kgm2;
    const double kp = 1.0 / (damping * perAmp * lag_s);
    return {kp, kp / (damping * damping * lag_s)};
}

PiGains speedDigits(const PiGains &gains, double digitsPerAmp, double speedPeriod_s)
{
    const double factor = kRadpsPerDigit * digitsPerAmp;
    return {gains.kp * factor, gains.ki * factor * speedPeriod_s};
}

PiGains speedGainsOf(const PiGains &digits, double digitsPerAmp, double speedPeriod_s)
{
    const double factor = kRadpsPerDigit * digitsPerAmp;
    return {digits.kp / factor, digits.ki / (factor * speedPeriod_s)};
}

double speedCrossover_radps(double lag_s, double damping) { return 1.0 / (damping * lag_s); }

double phaseMargin_deg(double damping)
{
    return (std::atan(damping) - std::atan(1.0 / damping)) * 180.0 / std::numbers::pi;
}

double poleDamping(double damping) { return (damping - 1.0) / 2.0; }

double stepOvershoot(double damping) { return overshoot(damping, false); }

double filteredStepOvershoot(double damping) { return overshoot(damping, true); }

} // namespace analysis
