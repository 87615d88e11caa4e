// The course by which a speed loop is measured against its load: the motor turns at one speed, and somebody, or a
// simulated board, puts a load on and takes it off. As for the power, that is a step to the speed that it has and back,
// which tells from when on it was held.
#pragma once

#include "lab/step_plan.h"

namespace lab {

struct LoadPlan : StepPlan {
    static constexpr const char *kEntry = "load plan"; ///< of its recording
    bool operator==(const LoadPlan &) const = default;
};

/// For 10 s, at half of what is allowed, forwards.
LoadPlan loadPlanFor(const Subject &subject, const drive::UserLimits &caps);

template <class Field>
void eachField(LoadPlan &plan, Field &&field)
{
    milliseconds length = 2 * plan.hold;
    field("rpm", plan.fromRpm);
    field("length ms", length);
    field("approach ms", plan.approach);
    field("max rpm", plan.caps.maxSpeedRpm);
    field("max A", plan.caps.maxCurrentAmps);
    plan.toRpm = plan.fromRpm;
    plan.hold = length / 2;
}

std::string objectionTo(const LoadPlan &plan, const Subject &subject);
Conditions conditionsOf(const LoadPlan &plan, const Subject &subject);
/// Whether the entry was one.
inline bool usable(const Recorded<LoadPlan> &found) { return found.polePairs > 0.0; }

} // namespace lab
