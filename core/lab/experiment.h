// An experiment: a plan of any kind and the motor that it is for. Plain values, which may cross threads.
#pragma once

#include "lab/course.h"
#include "lab/current_step_plan.h"
#include "lab/response_plan.h"
#include "lab/rest_plan.h"
#include "lab/spin_plan.h"
#include "lab/step_plan.h"

#include <variant>

namespace lab {

using Plan = std::variant<StepPlan, SpinPlan, ResponsePlan, RestPlan, CurrentStepPlan>;

struct Experiment {
    Plan plan;
    Subject subject;
};

/// Why it cannot be carried out as it stands, in a sentence without a full stop; empty if it can.
std::string objectionTo(const Experiment &experiment);
Conditions conditionsOf(const Experiment &experiment);
/// The whole time that it takes at most, the start of the motor left out.
milliseconds lengthOf(const Experiment &experiment);
std::unique_ptr<Course> courseOf(const Experiment &experiment);

/// The plan as an entry of its recording. @param regulator  that closes the speed loop; its gains are 0 if not known
record::Happening entryOf(const Experiment &experiment, const SpeedRegulator &regulator);
/// How it ended, as an entry of its recording.
record::Happening entryOfEnd(bool complete, const std::string &reason);
inline constexpr const char *kEndEntry = "experiment ended";

} // namespace lab
