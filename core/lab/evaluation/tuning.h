// Gains of a speed loop from the measured response of its motor: the greatest integral gain whose loop keeps a distance
// from instability, with what its step would look like. Pure; it proposes, and writes nothing.
//
// The distance is Ms, the largest of 1 / |1 + loop|, together with the phase margin, held at the worst end of each
// measured point's error. Below and above the measured points a motor K exp(-s T) / (s + a), fitted to them, stands in.
// Source: K. Astrom and T. Hagglund, Advanced PID Control (2006), ch. 4 and 6: integral gain under a bound on the
// sensitivity.
#pragma once

#include "lab/evaluation/response_evaluation.h"

#include <array>
#include <functional>
#include <optional>

namespace lab {

enum class Goal : std::uint8_t { Stiff, Medium, Quick };
inline constexpr std::array kGoals{Goal::Stiff, Goal::Medium, Goal::Quick};
const char *nameOf(Goal goal); ///< as command lines have it
/// What its loop keeps.
struct Distance {
    double ms = 0.0, phaseMargin_deg = 0.0;
};
Distance distanceOf(Goal goal);

/// Registers hold whole digits.
struct GainDigits {
    double proportional = 0.0, integral = 0.0; ///< A/rpm for each
    int most = 32767;
};

/// What a loop with these gains does.
struct LoopForecast {
    int proportional = 0, integral = 0; ///< digits
    double crossover_hz = 0.0, phaseMargin_deg = 0.0, ms = 0.0; ///< as measured points tell them
    /// Of a small step; no rise: it is not at 90 % within 2 s.
    std::optional<double> rise_s;
    double overshoot_pct = 0.0;
    bool stable = true; ///< else the loop cannot be run, and Ms and step mean nothing
};
struct GainCandidate : LoopForecast {
    Goal goal = Goal::Medium;
};

/// One for each goal that can be kept, in the order of kGoals.
/// @param nominalAmps  of the motor: the noise of the current's reference stays below a twentieth of it; 0: not known
/// @return  or why nothing can be proposed, in a sentence without a full stop
Result<std::vector<GainCandidate>, std::string> proposeGains(
    const SpeedResponse &measured, const GainDigits &digits, double nominalAmps);

/// The same for gains of the user's own, by proportional and integral digits; each call takes some milliseconds.
using Forecaster = std::function<LoopForecast(int, int)>;
Result<Forecaster, std::string> forecasterOf(
    const SpeedResponse &measured, const GainDigits &digits);

/// The response as it would be with another regulator around the same motor, with its margins and their intervals.
SpeedResponse withRegulator(SpeedResponse measured, const SpeedRegulator &regulator);

/// What gains are to do, before they are written.
struct Promise {
    double ms = 0.0; ///< at most
    double crossover_hz = 0.0, overshoot_pct = 0.0; ///< as predicted
};
/// A goal's own distance where the gains are those of a goal, else the predicted one.
Promise promiseOf(const LoopForecast &forecast, std::optional<Goal> goal);

/// What a loop that was measured makes of it.
enum class Kept : std::uint8_t {
    Yes,
    TooLively, ///< Ms is above a tenth more: nearer to instability
    TooSlow, ///< the crossover's interval ends below four fifths
    Overshoots, ///< the overshoot's interval begins more than 8 points above
    Unclear, ///< one of the three is not known
};
/// @param overshoot_pct  of its steps, as measured
Kept keptBy(const FrequencyResponse &proof, const std::optional<Estimate> &overshoot_pct,
    const Promise &promise);
/// It is known not to do what was promised: gains from its own response are nearer to that.
constexpr bool missed(Kept kept) { return kept != Kept::Yes && kept != Kept::Unclear; }

} // namespace lab
