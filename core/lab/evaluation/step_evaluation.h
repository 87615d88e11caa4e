// One speed step as its samples tell it: when it began, and how the speed followed. A pure function of what was
// recorded.
//
// The instant of a step is in the data: when the set-point jumps, the speed loop's proportional part makes the
// reference of Iq jump by gain times step at its next turn. Found, it is known to a sample; clocks of board and
// computer play no part. The speed is taken from the electrical angle where that was recorded, as the difference over 2
// to 5 ms, the shorter the faster the step, by Hall sensors over an electrical turn: the speed signals of boards count
// in steps of 6 rpm and are averaged already. Definitions of rise and settling: scope/step_response.h; of overshoot,
// too, but of a speed by the angle without its noise.
//
// Where a board records nothing there are values that were read one after the other: the step came between being asked
// for and being answered, and a time is known as well as two values are apart.
#pragma once

#include "capture/capture.h"
#include "scope/measurement.h"

#include <optional>

namespace lab {

using capture::Nanos;

/// Channels of one motor; they outlive the call and do not change meanwhile. `speed` is there, and `reference` unless
/// both `speed` and `current` were polled.
struct StepChannels {
    const capture::Channel *reference = nullptr; ///< of Iq
    const capture::Channel *current = nullptr; ///< Iq as measured
    const capture::Channel *speed = nullptr; ///< rpm
    const capture::Channel *angle = nullptr; ///< electrical, degrees
};

/// A step as it was asked for.
struct StepAsked {
    double from = 0.0, to = 0.0; ///< rpm, or A of a current
    Nanos asked = 0; ///< when it was handed to the link
    Nanos answered = 0; ///< when the board had agreed
    Nanos until = 0; ///< it is held at least so long
};

struct StepFacts {
    double polePairs = 0.0; ///< 0: not known; the speed signal is taken then
    double jumpPerRpm = 0.0; ///< A/rpm; 0: not known
};

struct StepRun {
    bool up = true;
    Nanos at = 0; ///< the instant of the step
    Nanos until = 0; ///< what comes then is not of this step any more
    bool found = false; ///< by the jump; else only when it was asked for is known
    std::optional<double> instantError_s; ///< to either side; empty: nothing is known of it
    bool cut = false; ///< it was not held to its end, or not recorded: nothing of it can be told
    std::optional<scope::WhyNot> unusable; ///< nothing of the speed can be told
    /// Empty: it does not have it, e.g. not settled.
    std::optional<double> rise_s, overshoot_pct, settling_s;
    std::optional<double> peakIq_a; ///< magnitude
    double speedWindow_s = 0.0; ///< of speedOf(), by which it was measured; 0: the speed signal
    /// Of values that were polled: the largest time between two of them, from the last one before the step until the
    /// speed has settled. 0: they were recorded.
    double pollDistance_s = 0.0;
    bool tooFast = false; ///< for them: nothing else of it is told
    double atLimit = 0.0; ///< share of the time in which the current's reference stood at its end
};

/// The instant at which the reference jumps as much as a step makes it; empty if it does so nowhere around that time.
/// @param jumpPerUnit  A for each unit of the step; 0: not known
struct StepInstant {
    Nanos at = 0;
    Nanos error = 0; ///< to either side
};
std::optional<StepInstant> stepInstant(
    const capture::Channel &reference, const StepAsked &asked, double jumpPerUnit);

/// A run of which nothing is told, because the step was held, or recorded, for less than nine tenths of `hold`: what
/// overshoots or settles comes later. Empty: it was held.
/// @param ramp  to where it is held
std::optional<StepRun> cutShort(
    const StepAsked &asked, const capture::Channel &response, Nanos hold, Nanos ramp = 0);

/// What the response of a step is over [from, until), into its run.
void measureStep(StepRun &run, const capture::Channel &response, Nanos from, Nanos until);
/// Largest magnitude, if anything is there.
std::optional<double> peakOf(const capture::Channel &channel, Nanos from, Nanos to);

StepRun evaluateStep(const StepChannels &channels, const StepAsked &asked, const StepFacts &facts);

/// The speed in rpm over [from, to) but for half a window at both ends, from the electrical angle in degrees: one
/// channel. No channel if samples are missing in between, or too few: no difference is taken across a gap.
/// @param window_s  of each difference; a value stands in its middle
capture::Capture speedOf(
    const capture::Channel &angle, double polePairs, double window_s, Nanos from, Nanos to);

} // namespace lab
