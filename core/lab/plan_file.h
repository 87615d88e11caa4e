// A plan from a file: the name of its kind and its numbers by their keys. Files are foreign: what is not known or not a
// number is refused with its name, and nothing is guessed. Bounds are checked where every plan's are
// (lab/experiment.h).
#pragma once

#include "lab/experiment.h"

#include <string>
#include <utility>
#include <vector>

namespace lab {

/// Key and number, such as {"from_rpm", 1000}: the names of a plan's fields in a recording, small and with underscores.
using PlanNumbers = std::vector<std::pair<std::string, double>>;

/// @param kind  "step", "current_step", "spin", "response", "current_response" or "rest"; what numbers leave out is as
///              the experiment has it of itself but both ends of a series of steps, and both gains of a response or
///              neither
/// @return  or why not, in a sentence without a full stop
Result<Plan, std::string> planOf(const std::string &kind, const PlanNumbers &numbers,
    const Subject &subject, const drive::UserLimits &caps);

} // namespace lab
