// What a recording says of the experiment in it, whichever that was. Pure.
#pragma once

#include "lab/evaluation/electrical_evaluation.h"
#include "lab/evaluation/mechanical_evaluation.h"
#include "lab/evaluation/response_evaluation.h"
#include "lab/evaluation/step_series.h"

#include <variant>

namespace lab {

/// A response that is not of the speed is of a current.
using Finding = std::variant<MeasuredSteps, Mechanics, Electrics, SpeedResponse, FrequencyResponse>;

/// Of the first experiment; or why there is none, or nothing follows from it, in a sentence without a full stop.
Result<Finding, std::string> findingIn(const capture::Capture &capture, const Happenings &all);

/// What the user has to know of it, sentences without a full stop.
const std::vector<std::string> &notesOf(const Finding &finding);

/// Why it is less than what was to be found, in a sentence without a full stop; empty: it is all of it.
std::string lackOf(const Finding &finding);

} // namespace lab
