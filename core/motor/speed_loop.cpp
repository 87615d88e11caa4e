#include "motor/speed_loop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace motor {

namespace {

constexpr double kRadpsPerDigit = 2.0 * std::numbers::pi / 10.0; // 0.1 Hz

constexpr double kStep = 0.02; // of the integration, in units of the lag
constexpr double kFine = 0.05; // the same for the quick part of an averaged loop

/// Kp K tau and Ki K tau^2: what is left of the gains when the lag is the unit of time.
PiGains normalised(const PiGains &gains, const SpeedPlant &plant, double lag_s)
{
    const double perLag = plant.kt_nmpa / plant.inertia_kgm2 * lag_s;
    return {gains.kp * perLag, gains.ki * perLag * lag_s};
}

/// The closed loop in units of its lag, tau = 1.
class NormalLoop {
public:
    /// @param filterRate  of the prefilter of the reference; 0: there is none
    NormalLoop(const PiGains &gains, double filterRate)
        : m_gains(gains)
        , m_filterRate(filterRate)
        , m_state{filterRate > 0.0 ? 0.0 : 1.0, 0.0, 0.0, 0.0}
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
        return {m_filterRate * (1.0 - at[0]), m_gains.ki * error,
            m_gains.kp * error + at[1] - at[2], at[2]};
    }
    State moved(const State &slope, double h) const
    {
        State to = m_state;
        for (std::size_t i = 0; i < to.size(); ++i)
            to[i] += h * slope[i];
        return to;
    }

    PiGains m_gains;
    double m_filterRate;
    State m_state;
};

/// The closed loop in seconds, its speed measured as an average over a window.
class AveragedLoop {
public:
    AveragedLoop(const PiGains &gains, const SpeedPlant &plant, const SpeedPath &path, double h)
        : m_gains(gains)
        , m_perAmp(plant.kt_nmpa / plant.inertia_kgm2)
        , m_h(h)
        , m_follow(-std::expm1(-h / path.quick_s))
        , m_window(
              static_cast<std::size_t>(std::clamp(path.average_s / h + 0.5, 1.0, kLongestWindow)),
              0.0)
    {
    }

    void step()
    {
        const double error = 1.0 - measured();
        m_integral += m_gains.ki * error * m_h;
        const double before = m_current;
        m_current += m_follow * (m_gains.kp * error + m_integral - m_current);
        m_speed += m_perAmp * m_h * (before + m_current) / 2.0;
        m_sum += m_speed - m_window[m_next];
        m_window[m_next] = m_speed;
        m_next = (m_next + 1) % m_window.size();
    }
    double measured() const { return m_sum / static_cast<double>(m_window.size()); }

private:
    static constexpr double kLongestWindow = 100e3;

    PiGains m_gains;
    double m_perAmp;
    double m_h;
    double m_follow; ///< of the way that the current goes in one step
    std::vector<double> m_window; ///< the newest speeds, a ring
    std::size_t m_next = 0;
    double m_sum = 0.0; ///< of the window
    double m_integral = 0.0;
    double m_current = 0.0;
    double m_speed = 0.0;
};

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

LoopMargin speedMargin(const PiGains &gains, const SpeedPlant &plant, double lag_s)
{
    const PiGains normal = normalised(gains, plant, lag_s);
    const auto magnitude = [&normal](double w) {
        return std::hypot(normal.kp, normal.ki / w) / (w * std::hypot(1.0, w));
    };
    // It falls with w everywhere: halve the interval, as a ratio.
    double low = 1e-6, high = 1e6;
    constexpr int kHalvings = 100;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = std::sqrt(low * high);
        (magnitude(middle) > 1.0 ? low : high) = middle;
    }
    const double phase = std::atan2(normal.kp * low, normal.ki) - std::atan(low);
    return {low / lag_s, phase * 180.0 / std::numbers::pi};
}

StepPrediction predictSpeedStep(const PiGains &gains, const SpeedPlant &plant,
    const SpeedPath &path, double duration_s, int samples)
{
    constexpr int kMostSamples = 10'000, kMostSteps = 200;
    const int count = std::clamp(samples, 2, kMostSamples);
    StepPrediction step;
    step.period_s = duration_s / (count - 1);
    const double fine = kFine * path.quick_s;
    const int between =
        static_cast<int>(std::clamp(std::ceil(step.period_s / fine), 1.0, double{kMostSteps}));
    AveragedLoop loop(gains, plant, path, step.period_s / between);
    for (int i = 0; i < count; ++i) {
        const double speed = std::clamp(loop.measured(), -kFar, kFar);
        step.response.push_back(speed);
        for (int k = 0; k < between && std::abs(speed) < kFar; ++k)
            loop.step();
    }
    measureStep(step);
    return step;
}

double filteredStepOvershoot(double damping)
{
    const double end = 12.0 * damping * damping; // the peak comes before
    NormalLoop loop(
        {1.0 / damping, 1.0 / (damping * damping * damping)}, 1.0 / (damping * damping));
    double peak = 0.0;
    for (double t = 0.0; t < end; t += kStep) {
        loop.step(kStep);
        peak = std::max(peak, loop.speed());
    }
    return std::max(0.0, peak - 1.0);
}

} // namespace motor
