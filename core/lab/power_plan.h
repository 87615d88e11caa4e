// The course by which the power of a motor is measured: a speed is held, with whatever load it has.
#pragma once

#include "lab/held_plan.h"

namespace lab {

struct PowerPlan : HeldPlan {
    static constexpr const char *kEntry = "power plan"; ///< of its recording
    double rsOhm = 0.0, deadVolts = 0.0; ///< of a phase; along the current. 0: not known
    bool operator==(const PowerPlan &) const = default;
};

/// For 5 s.
PowerPlan powerPlanFor(const Subject &subject, const drive::UserLimits &caps);

template <class Field>
void eachField(PowerPlan &plan, Field &&field)
{
    eachField(static_cast<HeldPlan &>(plan), field);
    field("rs ohm", plan.rsOhm);
    field("dead time V", plan.deadVolts);
}

std::string objectionTo(const PowerPlan &plan, const Subject &subject);
Conditions conditionsOf(const PowerPlan &plan, const Subject &subject);
/// Whether the entry was one.
inline bool usable(const Recorded<PowerPlan> &found) { return found.polePairs > 0.0; }

} // namespace lab
