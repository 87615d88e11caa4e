#include "lab/power_plan.h"

#include "drive/motion_limits.h"

#include <algorithm>
#include <cmath>

namespace lab {

PowerPlan powerPlanFor(const Subject &subject, const drive::UserLimits &caps)
{
    constexpr double kUsualSpeed = 0.5;
    PowerPlan plan;
    plan.caps = caps;
    plan.hold = milliseconds(2500);
    plan.fromRpm = plan.toRpm =
        static_cast<int>(std::lround(kUsualSpeed * drive::realBoundsOf(subject.limits, caps).rpm));
    return plan;
}

std::string objectionTo(const PowerPlan &plan, const Subject &subject)
{
    const Registers &has = subject.registers;
    if (std::min({has.angle, has.currentD, has.voltage, has.voltageD}) == 0
        || !(subject.limits.polePairs > 0.0))
        return "this board does not record voltages, currents and the angle of its rotor";
    if (!(subject.limits.torquePerAmp > 0.0))
        return "the board does not tell the strength of the magnets, without which no torque is "
               "known";
    if (plan.fromRpm == 0)
        return "the motor has to turn";
    return plan.hold < milliseconds(500) || plan.hold > milliseconds(15'000) ? "it takes 1 to 30 s"
                                                                             : "";
}

Conditions conditionsOf(const PowerPlan &plan, const Subject &subject)
{
    constexpr double kMargin = 0.25; // of the speed: loads jump
    const Registers &of = subject.registers;
    Conditions conditions = conditionsOf(static_cast<const StepPlan &>(plan), subject);
    conditions.margin_rpm = std::max(kLeastMargin_rpm, kMargin * std::abs(plan.fromRpm));
    conditions.recorded = {of.current, of.currentD, of.voltage, of.voltageD, of.speed, of.angle};
    return conditions;
}

} // namespace lab
