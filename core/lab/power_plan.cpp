#include "lab/power_plan.h"

#include <algorithm>

namespace lab {

using namespace std::chrono_literals;

PowerPlan powerPlanFor(const Subject &subject, const drive::UserLimits &caps)
{
    return {heldPlanFor(subject, caps, 5s)};
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
    return plan.length() < 1s || plan.length() > 30s ? "it takes 1 to 30 s" : "";
}

Conditions conditionsOf(const PowerPlan &plan, const Subject &subject)
{
    constexpr double kLoadsJump = 0.25;
    const Registers &of = subject.registers;
    return conditionsOf(plan, subject, kLoadsJump,
        {of.current, of.currentD, of.voltage, of.voltageD, of.speed, of.angle});
}

} // namespace lab
