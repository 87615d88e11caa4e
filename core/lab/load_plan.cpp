#include "lab/load_plan.h"

#include "drive/motion_limits.h"

#include <algorithm>
#include <cmath>

namespace lab {

using namespace std::chrono_literals;

LoadPlan loadPlanFor(const Subject &subject, const drive::UserLimits &caps)
{
    constexpr double kUsualSpeed = 0.5;
    LoadPlan plan;
    plan.caps = caps;
    plan.hold = 5s;
    plan.fromRpm = plan.toRpm =
        static_cast<int>(std::lround(kUsualSpeed * drive::realBoundsOf(subject.limits, caps).rpm));
    return plan;
}

std::string objectionTo(const LoadPlan &plan, const Subject &subject)
{
    if (subject.registers.angle == 0 || !(subject.limits.polePairs > 0.0))
        return "this board does not record the angle of its rotor";
    if (plan.fromRpm == 0)
        return "the motor has to turn";
    return plan.hold < 1s || plan.hold > 15s ? "it takes 2 to 30 s" : "";
}

/// A speed that gives way is what is measured.
Conditions conditionsOf(const LoadPlan &plan, const Subject &subject)
{
    constexpr double kMargin = 0.4; // of the speed
    const Registers &of = subject.registers;
    Conditions conditions = conditionsOf(static_cast<const StepPlan &>(plan), subject);
    conditions.margin_rpm = std::max(kLeastMargin_rpm, kMargin * std::abs(plan.fromRpm));
    conditions.recorded = {of.reference, of.current, of.speed, of.angle};
    return conditions;
}

} // namespace lab
