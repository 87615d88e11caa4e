#include "lab/held_plan.h"

#include "drive/motion_limits.h"

#include <algorithm>
#include <cmath>

namespace lab {

HeldPlan heldPlanFor(const Subject &subject, const drive::UserLimits &caps, milliseconds length)
{
    constexpr double kUsualSpeed = 0.5;
    HeldPlan plan;
    plan.caps = caps;
    plan.hold = length / 2;
    plan.fromRpm = plan.toRpm =
        static_cast<int>(std::lround(kUsualSpeed * drive::realBoundsOf(subject.limits, caps).rpm));
    return plan;
}

Conditions conditionsOf(const HeldPlan &plan, const Subject &subject, double share,
    std::vector<drive::RegisterId> recorded)
{
    Conditions conditions = conditionsOf(static_cast<const StepPlan &>(plan), subject);
    conditions.margin_rpm = std::max(kLeastMargin_rpm, share * std::abs(plan.fromRpm));
    conditions.recorded = std::move(recorded);
    return conditions;
}

} // namespace lab
