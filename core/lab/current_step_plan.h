// A series of current steps: a motor turns at a speed, and its torque, or the current along its magnets, jumps to and
// fro. Meanwhile nothing holds the speed, so each current is held for milliseconds only, and no longer than the speed
// stays near where it was. Afterwards the motor coasts back to its speed, and speed control takes it over again: it is
// never braked.
#pragma once

#include "lab/course.h"
#include "lab/recorded_plan.h"

#include <string>

namespace lab {

struct CurrentStepPlan {
    static constexpr const char *kEntry = "current step plan"; ///< of its recording
    int flux = 0; ///< 1: along the magnets, beside the Iq that holds the speed; 0: torque
    double fromAmps = 0.0, toAmps = 0.0; ///< peak, signed
    int repeat = 5; ///< steps there, and as many back
    milliseconds hold{20}; ///< of each current
    int rpm = 0; ///< at which it turns, signed
    milliseconds approach = kApproach;
    drive::UserLimits caps = {}; ///< the user's
    bool operator==(const CurrentStepPlan &) const = default;
};

/// At 0.35 of the allowed speed, without a sensor 0.45, the way that the torques push.
CurrentStepPlan currentStepPlanFor(const Subject &subject, bool flux, double fromAmps,
    double toAmps, const drive::UserLimits &caps);

/// Its fields by the names that recordings and files have them by.
template <class Field>
void eachField(CurrentStepPlan &plan, Field &&field)
{
    field("flux", plan.flux);
    field("from A", plan.fromAmps);
    field("to A", plan.toAmps);
    field("repeat", plan.repeat);
    field("hold ms", plan.hold);
    field("rpm", plan.rpm);
    field("approach ms", plan.approach);
    field("max rpm", plan.caps.maxSpeedRpm);
    field("max A", plan.caps.maxCurrentAmps);
}

std::string objectionTo(const CurrentStepPlan &plan, const Subject &subject);
Conditions conditionsOf(const CurrentStepPlan &plan, const Subject &subject);
std::unique_ptr<Course> courseOf(const CurrentStepPlan &plan, const Subject &subject);

/// Whether the entry was one.
bool usable(const Recorded<CurrentStepPlan> &found);

} // namespace lab
