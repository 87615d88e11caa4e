// The course by which the power of a motor is measured: it turns at one speed, with whatever load it has. That is a
// step to the speed that it has and back, which tells from when on it was held.
#pragma once

#include "lab/step_plan.h"

namespace lab {

struct PowerPlan : StepPlan {
    static constexpr const char *kEntry = "power plan"; ///< of its recording
    double rsOhm = 0.0, deadVolts = 0.0; ///< of a phase; along the current. 0: not known
    bool operator==(const PowerPlan &) const = default;
};

/// For 5 s, at half of what is allowed, forwards.
PowerPlan powerPlanFor(const Subject &subject, const drive::UserLimits &caps);

template <class Field>
void eachField(PowerPlan &plan, Field &&field)
{
    milliseconds length = 2 * plan.hold;
    field("rpm", plan.fromRpm);
    field("length ms", length);
    field("rs ohm", plan.rsOhm);
    field("dead time V", plan.deadVolts);
    field("approach ms", plan.approach);
    field("max rpm", plan.caps.maxSpeedRpm);
    field("max A", plan.caps.maxCurrentAmps);
    plan.toRpm = plan.fromRpm;
    plan.hold = length / 2;
}

std::string objectionTo(const PowerPlan &plan, const Subject &subject);
Conditions conditionsOf(const PowerPlan &plan, const Subject &subject);
/// Whether the entry was one.
inline bool usable(const Recorded<PowerPlan> &found) { return found.polePairs > 0.0; }

} // namespace lab
