// The course by which a speed loop is measured against its load: a speed is held, and somebody, or a simulated board,
// puts a load on and takes it off.
#pragma once

#include "lab/held_plan.h"

namespace lab {

struct LoadPlan : HeldPlan {
    static constexpr const char *kEntry = "load plan"; ///< of its recording
    bool operator==(const LoadPlan &) const = default;
};

/// For 10 s.
LoadPlan loadPlanFor(const Subject &subject, const drive::UserLimits &caps);
std::string objectionTo(const LoadPlan &plan, const Subject &subject);
Conditions conditionsOf(const LoadPlan &plan, const Subject &subject);
/// Whether the entry was one.
inline bool usable(const Recorded<LoadPlan> &found)
{
    return found.polePairs >= 1.0 && found.plan.fromRpm != 0;
}

} // namespace lab
