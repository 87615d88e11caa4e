#include "lab/evaluation/tuning.h"

#include "lab/maths/cross_spectra.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

namespace lab {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// K exp(-s T) / (s + a): rpm for each ampere.
struct Model {
    double gain = 0.0, pole = 0.0, delay_s = 0.0;
    Complex at(double hz) const { return at(hz, late(hz, delay_s)); }
    /// @param late  what the delay does at this frequency
    Complex at(double hz, Complex late) const
    {
        return gain * late / (Complex(0.0, kTurn * hz) + pole);
    }
    static Complex late(double hz, double delay_s)
    {
        return std::exp(-Complex(0.0, kTurn * hz) * delay_s);
    }
};

struct Known {
    double hz = 0.0;
    Complex motor; ///< as the regulator sees it: rpm for each ampere
    double relative = 0.0; ///< standard error
};

/// What a delay does at each point: costly, and the same for all poles.
std::vector<Complex> lateAt(const std::vector<Known> &points, double delay_s)
{
    std::vector<Complex> late;
    late.reserve(points.size());
    for (const Known &point : points)
        late.push_back(Model::late(point.hz, delay_s));
    return late;
}

/// The best gain for a pole and a delay, and how badly that fits; what is far above `around_hz` counts for little.
double fitGain(Model &model, const std::vector<Known> &points, const std::vector<Complex> &late,
    double around_hz)
{
    model.gain = 1.0;
    double along = 0.0, squares = 0.0, weights = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Known &point = points[i];
        const double above = point.hz / around_hz;
        const double weight =
            1.0 / (1e-4 + point.relative * point.relative) / (1.0 + above * above * above * above);
        const Complex ratio = model.at(point.hz, late[i]) / point.motor;
        along += weight * ratio.real();
        squares += weight * std::norm(ratio);
        weights += weight;
    }
    model.gain = along / squares;
    return weights - along * along / squares;
}

Model fitted(const std::vector<Known> &points, double around_hz)
{
    constexpr double kLeastPole = 0.02, kMostPole = 500.0, kMostDelay_s = 20e-3;
    constexpr int kSteps = 40, kTurns = 4;
    Model best{0.0, 1.0, 0.0};
    double least = fitGain(best, points, lateAt(points, best.delay_s), around_hz);
    double poleSpan = std::log(kMostPole / kLeastPole), delaySpan = kMostDelay_s;
    double poleMiddle = std::log(std::sqrt(kMostPole * kLeastPole)), delayMiddle = kMostDelay_s / 2;
    for (int turn = 0; turn < kTurns; ++turn) {
        for (int k = 0; k <= kSteps; ++k) {
            const double delay_s =
                std::max(0.0, delayMiddle + delaySpan * (k / double(kSteps) - 0.5));
            const std::vector<Complex> late = lateAt(points, delay_s);
            for (int i = 0; i <= kSteps; ++i) {
                Model model{
                    0.0, std::exp(poleMiddle + poleSpan * (i / double(kSteps) - 0.5)), delay_s};
                const double left = fitGain(model, points, late, around_hz);
                if (left < least && model.gain > 0.0) {
                    least = left;
                    best = model;
                }
            }
        }
        poleMiddle = std::log(best.pole);
        delayMiddle = best.delay_s;
        poleSpan /= 8.0;
        delaySpan /= 8.0;
    }
    return best;
}

/// The measured points, with the model's around them.
std::vector<Known> wholeBand(const std::vector<Known> &measured, const Model &model)
{
    constexpr double kLowest_hz = 0.1, kHighest_hz = 300.0, kStep = 1.1;
    std::vector<Known> all;
    for (double hz = kLowest_hz; hz < measured.front().hz; hz *= kStep)
        all.push_back({hz, model.at(hz), 0.0});
    all.insert(all.end(), measured.begin(), measured.end());
    for (double hz = measured.back().hz * kStep; hz < kHighest_hz; hz *= kStep)
        all.push_back({hz, model.at(hz), 0.0});
    return all;
}

struct Margins {
    double crossover_hz = 0.0, phaseMargin_deg = 0.0;
    double ms = 0.0; ///< with every point as it was measured
    double worstMs = 0.0; ///< at the worst end of each point's error
    double last = 0.0; ///< gain of the loop at the end of the band
};

Margins marginsOf(const std::vector<Known> &band, const SpeedRegulator &regulator)
{
    constexpr double kNormal = 1.96, kLeastDistance = 1e-3;
    Margins margins;
    Complex before;
    double before_hz = 0.0;
    for (const Known &point : band) {
        const Complex loop = point.motor * regulatorAt(regulator, point.hz);
        const double distance = std::abs(1.0 + loop);
        const double worst = distance - kNormal * point.relative * std::abs(loop);
        margins.ms = std::max(margins.ms, 1.0 / std::max(kLeastDistance, distance));
        margins.worstMs = std::max(margins.worstMs, 1.0 / std::max(kLeastDistance, worst));
        if (&point != &band.front() && std::abs(before) >= 1.0 && std::abs(loop) < 1.0) {
            // The last one counts: beyond it the gain stays below 1.
            const double from = std::log(std::abs(before)), to = std::log(std::abs(loop));
            const double share = from / (from - to);
            margins.crossover_hz = before_hz * std::pow(point.hz / before_hz, share);
            const double phase =
                std::arg(before) + share * std::remainder(std::arg(loop) - std::arg(before), kTurn);
            margins.phaseMargin_deg = std::remainder(phase * 360.0 / kTurn + 180.0, 360.0);
        }
        before = loop;
        before_hz = point.hz;
    }
    margins.last = std::abs(before);
    return margins;
}

SpeedRegulator regulatorOf(
    const GainDigits &digits, int proportional, int integral, double period_s)
{
    return {proportional * digits.proportional, integral * digits.integral, period_s};
}

/// A small step: no current limit, no dry friction.
void predictStep(LoopForecast &candidate, const Model &model, const SpeedRegulator &regulator)
{
    constexpr double kPart_s = 1e-4, kLength_s = 2.0, kLow = 0.1, kHigh = 0.9;
    const auto each = static_cast<int>(std::max(1L, std::lround(regulator.period_s / kPart_s)));
    std::deque<double> late(static_cast<std::size_t>(std::lround(model.delay_s / kPart_s)) + 1);
    double speed = 0.0, sum = 0.0, amps = 0.0, most = 0.0;
    std::optional<double> low_s, high_s;
    for (int part = 0; part * kPart_s < kLength_s; ++part) {
        if (part % each == 0) {
            const double error = 1.0 - late.front();
            sum += error;
            amps = regulator.proportional * error + regulator.integral * sum;
        }
        speed += (model.gain * amps - model.pole * speed) * kPart_s;
        late.pop_front();
        late.push_back(speed);
        most = std::max(most, speed);
        if (!low_s && speed >= kLow)
            low_s = part * kPart_s;
        if (!high_s && speed >= kHigh)
            high_s = part * kPart_s;
    }
    if (high_s)
        candidate.rise_s = *high_s - *low_s;
    candidate.overshoot_pct = std::max(0.0, most - 1.0) * 100.0;
}

/// The greatest integral gain that keeps the distance; 0: none does.
int greatestIntegral(const std::vector<Known> &band, const GainDigits &digits, int proportional,
    double period_s, const Distance &distance)
{
    const auto keeps = [&](int integral) {
        const Margins margins =
            marginsOf(band, regulatorOf(digits, proportional, integral, period_s));
        return margins.crossover_hz > 0.0 && margins.worstMs <= distance.ms
            && margins.phaseMargin_deg >= distance.phaseMargin_deg;
    };
    if (!keeps(1))
        return 0;
    int least = 1, most = digits.most + 1;
    while (most - least > 1) {
        const int middle = least + (most - least) / 2;
        (keeps(middle) ? least : most) = middle;
    }
    return least;
}

/// What a measured response says of its motor.
struct Measured {
    SpeedRegulator now;
    std::vector<Known> points, band;
};

Result<Measured, std::string> measuredMotor(const SpeedResponse &measured, const GainDigits &digits)
{
    const SpeedRegulator &now = measured.regulator;
    if (!(now.proportional > 0.0) || !(digits.proportional > 0.0) || !(digits.integral > 0.0))
        return fail(std::string("the board does not tell its gains, so its loop is not known"));
    constexpr double kLeast_s = 1e-5, kMost_s = 0.1;
    if (!(now.period_s >= kLeast_s && now.period_s <= kMost_s))
        return fail(std::string("no speed loop has the period that the board tells"));
    constexpr double kLeastCoherence = 0.8;
    constexpr std::size_t kLeastPoints = 5;
    Measured motor{now, {}, {}};
    for (const ResponsePoint &point : measured.points)
        if (point.coherence >= kLeastCoherence)
            motor.points.push_back(
                {point.hz, point.loop / regulatorAt(now, point.hz), point.loopRelative});
    if (motor.points.size() < kLeastPoints)
        return fail(std::string("too few frequencies of the response are clear enough"));
    constexpr double kUsual_hz = 15.0;
    motor.band = wholeBand(motor.points, fitted(motor.points, kUsual_hz));
    return motor;
}

LoopForecast forecastOf(
    const Measured &motor, const GainDigits &digits, int proportional, int integral)
{
    const SpeedRegulator regulator =
        regulatorOf(digits, proportional, integral, motor.now.period_s);
    const Margins margins = marginsOf(motor.band, regulator);
    LoopForecast forecast{proportional, integral, margins.crossover_hz, margins.phaseMargin_deg,
        margins.ms, std::nullopt, 0.0};
    // Where the gain is still above 1 at the end of the band, nothing is known of the phase at its crossover.
    forecast.stable = margins.last < 1.0;
    if (!forecast.stable || !(margins.crossover_hz > 0.0))
        return forecast;
    predictStep(forecast, fitted(motor.points, margins.crossover_hz), regulator);
    constexpr double kMostOvershoot_pct = 100.0; // a swing that does not grow stays below
    forecast.stable = margins.phaseMargin_deg > 0.0 && forecast.overshoot_pct < kMostOvershoot_pct;
    return forecast;
}

} // namespace

const char *nameOf(Goal goal)
{
    constexpr std::array kNames{"stiff", "medium", "quick"};
    return kNames[static_cast<std::size_t>(goal)];
}

Distance distanceOf(Goal goal)
{
    constexpr std::array kDistances{Distance{1.4, 60.0}, Distance{1.7, 50.0}, Distance{2.0, 45.0}};
    return kDistances[static_cast<std::size_t>(goal)];
}

Result<std::vector<GainCandidate>, std::string> proposeGains(
    const SpeedResponse &measured, const GainDigits &digits, double nominalAmps)
{
    const auto motor = measuredMotor(measured, digits);
    if (!motor)
        return fail(motor.error());
    constexpr double kRange = 16.0, kStep = 1.06, kNoise = 0.05;
    const double nowDigits = motor->now.proportional / digits.proportional;
    double most = std::min<double>(digits.most, nowDigits * kRange);
    if (nominalAmps > 0.0 && measured.referenceNoise_a > 0.0)
        most = std::min(most,
            std::max(
                nowDigits / kRange, nowDigits * kNoise * nominalAmps / measured.referenceNoise_a));
    std::vector<GainCandidate> all;
    for (const Goal goal : kGoals) {
        int best = 0, withBest = 0;
        for (double at = std::max(1.0, nowDigits / kRange); at <= most; at *= kStep) {
            const int proportional = static_cast<int>(std::lround(at));
            const int integral = greatestIntegral(
                motor->band, digits, proportional, motor->now.period_s, distanceOf(goal));
            if (integral > best) {
                best = integral;
                withBest = proportional;
            }
        }
        if (best > 0)
            all.push_back({forecastOf(*motor, digits, withBest, best), goal});
    }
    if (all.empty())
        return fail(std::string("no gains keep the distance from instability that is asked for"));
    return all;
}

Result<Forecaster, std::string> forecasterOf(
    const SpeedResponse &measured, const GainDigits &digits)
{
    const auto motor = measuredMotor(measured, digits);
    if (!motor)
        return fail(motor.error());
    return Forecaster([motor = *motor, digits](int proportional, int integral) {
        return forecastOf(motor, digits, proportional, integral);
    });
}

SpeedResponse withRegulator(SpeedResponse measured, const SpeedRegulator &regulator)
{
    for (ResponsePoint &point : measured.points)
        point.loop *= regulatorAt(regulator, point.hz) / regulatorAt(measured.regulator, point.hz);
    measured.regulator = regulator;
    measured.crossover_hz = measured.phaseMargin_deg = measured.ms = std::nullopt;
    measured.notes.clear();
    addMargins(measured, kLeastMarginCoherence);
    return measured;
}

Promise promiseOf(const LoopForecast &forecast, std::optional<Goal> goal)
{
    return {
        goal ? distanceOf(*goal).ms : forecast.ms, forecast.crossover_hz, forecast.overshoot_pct};
}

Kept keptBy(const FrequencyResponse &proof, const std::optional<Estimate> &overshoot_pct,
    const Promise &promise)
{
    constexpr double kMostMs = 1.1;
    constexpr double kLeastCrossover = 0.8; // measured twice the same loop differs by some 8 %
    constexpr double kMoreOvershoot = 8.0; // points: loops that keep the rest differ by up to 5
    if (proof.ms && proof.ms->value > kMostMs * promise.ms)
        return Kept::TooLively;
    if (!proof.ms || !proof.crossover_hz)
        return Kept::Unclear;
    const double most_hz = proof.crossover_hz->high.value_or(proof.crossover_hz->value);
    if (most_hz < kLeastCrossover * promise.crossover_hz)
        return Kept::TooSlow;
    if (!overshoot_pct)
        return Kept::Unclear;
    const double least_pct = overshoot_pct->low.value_or(overshoot_pct->value);
    return least_pct > promise.overshoot_pct + kMoreOvershoot ? Kept::Overshoots : Kept::Yes;
}

} // namespace lab
