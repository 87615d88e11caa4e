// The course in which a motor turns at one speed: a step to the speed that it has and back, which tells from when on it
// was held.
#pragma once

#include "lab/step_plan.h"

namespace lab {

struct HeldPlan : StepPlan {
    milliseconds length() const { return 2 * hold; }
    bool operator==(const HeldPlan &) const = default;
};

/// At half of what is allowed, forwards.
HeldPlan heldPlanFor(const Subject &subject, const drive::UserLimits &caps, milliseconds length);

template <class Field>
void eachField(HeldPlan &plan, Field &&field)
{
    milliseconds length = plan.length();
    field("rpm", plan.fromRpm);
    field("length ms", length);
    field("approach ms", plan.approach);
    field("max rpm", plan.caps.maxSpeedRpm);
    field("max A", plan.caps.maxCurrentAmps);
    plan.toRpm = plan.fromRpm;
    plan.hold = length / 2;
}

/// @param share     of the speed, that loads may move it beyond
/// @param recorded  signals
Conditions conditionsOf(const HeldPlan &plan, const Subject &subject, double share,
    std::vector<drive::RegisterId> recorded);

} // namespace lab
