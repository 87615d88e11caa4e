// What a recording says of a series of current steps (lab/current_step_plan.h): how the measured current followed its
// reference. Pure. The instant is the sample at which the recorded reference jumps, which it does by just the step.
#pragma once

#include "lab/evaluation/step_series.h"

namespace lab {

/// The first such series in a recording; or why there is none, in a sentence without a full stop.
Result<MeasuredSteps, std::string> currentSteps(
    const capture::Capture &capture, const Happenings &all);

} // namespace lab
