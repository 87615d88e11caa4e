// A series of speed steps: the motor is brought to `from`, then `repeat` times stepped to `to` and back, each speed
// held for `hold`. The plan is written into the recording of its series, so that the file alone says what was wanted.
#pragma once

#include "lab/course.h"
#include "lab/recorded_plan.h"

#include <string>

namespace lab {

struct StepPlan {
    static constexpr const char *kEntry = "step plan"; ///< of its recording
    int fromRpm = 0, toRpm = 0; ///< mechanical, signed
    int repeat = 1; ///< steps up and as many down
    milliseconds hold{500}; ///< of each speed
    milliseconds approach = kApproach; ///< the ramp to `from`, and the way back
    drive::UserLimits caps = {}; ///< the user's
    bool operator==(const StepPlan &) const = default;
};

/// Its fields by the names that recordings and files have them by.
template <class Field>
void eachField(StepPlan &plan, Field &&field)
{
    field("from rpm", plan.fromRpm);
    field("to rpm", plan.toRpm);
    field("repeat", plan.repeat);
    field("hold ms", plan.hold);
    field("approach ms", plan.approach);
    field("max rpm", plan.caps.maxSpeedRpm);
    field("max A", plan.caps.maxCurrentAmps);
}
template <class Field>
void eachGain(const StepPlan &, SpeedRegulator &regulator, Field &&field)
{
    field("jump A per rpm", regulator.proportional);
}

std::string objectionTo(const StepPlan &plan, const Subject &subject);
Conditions conditionsOf(const StepPlan &plan, const Subject &subject);
std::unique_ptr<Course> courseOf(const StepPlan &plan, const Subject &subject);

/// What the speed loop adds to the reference of Iq at once for each rpm of a step: A/rpm. 0: not known.
/// @param gain, exponent  numbers of the subject's registers, as read
double jumpPerRpm(const Subject &subject, double gain, double exponent);

/// Whether the entry was one. More repetitions than there can be are as many.
bool usable(const Recorded<StepPlan> &found);

} // namespace lab
