// What a recording says of moves of a shaft (lab/position_plan.h): how it came to where it was to go. Pure. Where it is
// comes from the electrical angle. A move begins when the board had it, which is known as well as it was asked for and
// answered: what it does at first is too gentle to be found.
#pragma once

#include "lab/evaluation/step_series.h"

namespace lab {

/// Where a shaft is over [from, to), in mechanical degrees since then: one channel. No channel if samples are missing.
/// @param angle  electrical, in degrees
capture::Capture positionOf(const capture::Channel &angle, double polePairs, Nanos from, Nanos to);

/// The first such series in a recording; or why there is none, in a sentence without a full stop. Its times count from
/// the beginning of a move, and have its way in them.
Result<MeasuredSteps, std::string> positionSteps(
    const capture::Capture &capture, const Happenings &all);

} // namespace lab
