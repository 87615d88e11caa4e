#include "lab/load_plan.h"

namespace lab {

using namespace std::chrono_literals;

LoadPlan loadPlanFor(const Subject &subject, const drive::UserLimits &caps)
{
    return {heldPlanFor(subject, caps, 10s)};
}

std::string objectionTo(const LoadPlan &plan, const Subject &subject)
{
    if (subject.registers.angle == 0 || !(subject.limits.polePairs > 0.0))
        return "this board does not record the angle of its rotor";
    if (plan.fromRpm == 0)
        return "the motor has to turn";
    return plan.length() < 2s || plan.length() > 30s ? "it takes 2 to 30 s" : "";
}

/// A speed that gives way is what is measured.
Conditions conditionsOf(const LoadPlan &plan, const Subject &subject)
{
    constexpr double kGivesWay = 0.4;
    const Registers &of = subject.registers;
    return conditionsOf(plan, subject, kGivesWay, {of.reference, of.current, of.speed, of.angle});
}

} // namespace lab
