// The course by which frequency responses are measured: the set-point of the speed is above or below a speed at random,
// each time for 30 or 60 ms, so that every frequency up to some 60 Hz is in it; the two lengths fill each other's
// zeros. Where set-points leave with every exchange of the line it is 5 or 10 ms, and some 200 Hz. The current loop is
// measured by the same: its reference jumps with each set-point, and moves with each turn of the speed loop.
#pragma once

#include "lab/course.h"
#include "lab/recorded_plan.h"

#include <string>

namespace lab {

struct ResponsePlan {
    static constexpr const char *kEntry = "response plan"; ///< of its recording
    int current = 0; ///< 1: the current loop is what is asked about; 0: motor and speed loop
    int rpm = 0; ///< around which it goes, signed
    int amplitudeRpm = 60;
    int kp = 0, ki = 0; ///< digits of the speed loop's gains meanwhile; kp 0: as the board has them
    milliseconds length{16000};
    milliseconds approach = kApproach;
    std::uint32_t seed = 1; ///< of the times
    drive::UserLimits caps = {}; ///< the user's
    bool operator==(const ResponsePlan &) const = default;
};

/// Around 0.4 of what is allowed, forwards, by 3 % of the speed, at least ten digits of the set-point.
ResponsePlan responsePlanFor(const Subject &subject, const drive::UserLimits &caps);
/// The same for the current loop, which takes less time.
ResponsePlan currentResponsePlanFor(const Subject &subject, const drive::UserLimits &caps);
/// How far the speed goes to either side of this one, unless told otherwise.
int usualAmplitudeRpm(const Subject &subject, int rpm);

/// Its fields by the names that recordings and files have them by.
template <class Field>
void eachField(ResponsePlan &plan, Field &&field)
{
    field("current loop", plan.current);
    field("rpm", plan.rpm);
    field("amplitude rpm", plan.amplitudeRpm);
    field("speed kp", plan.kp);
    field("speed ki", plan.ki);
    field("length ms", plan.length);
    field("approach ms", plan.approach);
    field("seed", plan.seed);
    field("max rpm", plan.caps.maxSpeedRpm);
    field("max A", plan.caps.maxCurrentAmps);
}
template <class Field>
void eachGain(const ResponsePlan &, SpeedRegulator &regulator, Field &&field)
{
    field("proportional A per rpm", regulator.proportional);
    field("integral A per rpm", regulator.integral);
    field("period s", regulator.period_s);
}

/// Why samples that are so far apart tell no response; empty if they do.
std::string tooFarApart(double step_s, bool ofCurrent);
std::string objectionTo(const ResponsePlan &plan, const Subject &subject);
Conditions conditionsOf(const ResponsePlan &plan, const Subject &subject);
std::unique_ptr<Course> courseOf(const ResponsePlan &plan, const Subject &subject);

/// Whether the entry was one.
bool usable(const Recorded<ResponsePlan> &found);

} // namespace lab
