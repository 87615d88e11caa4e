// The course by which inertia and friction are measured: in torque control the motor is accelerated and left to coast
// between two speeds, with torques that differ from time to time. It is never braked: what a motor returns lifts the
// bus of a supply that takes nothing back. How hard it accelerates, and how much of the torque that held its speed is
// taken away, follow from how it went before: a way from one speed to the other takes some tenths of a second, so that
// the link is fast enough to end it. With currents along the magnets beside them, inductances follow from the same
// course.
//
// Of a board that records nothing by itself the speed is led up and down between them by ramps instead, while speed and
// current are read as often as the link gives: up fast, which takes current for the inertia, and down slowly, which
// brakes little.
#pragma once

#include "lab/course.h"
#include "lab/recorded_plan.h"

#include <string>

namespace lab {

struct SpinPlan {
    static constexpr const char *kEntry = "spin plan"; ///< of its recording
    static constexpr milliseconds kListen{300}; ///< to what holds the first speed
    /// Of a board that records nothing: its ramps, and how long their ends are held.
    static constexpr milliseconds kUp{1500}, kDown{3000}, kHold{500};
    static constexpr milliseconds kRound = kUp + kDown + 2 * kHold;
    int lowRpm = 0, highRpm = 0; ///< of the same sign; low is nearer to 0
    milliseconds length{8000}; ///< spinPlanFor() says a longer one for most motors
    milliseconds approach = kApproach;
    /// Most along the magnets, to either side; each way has another. 0: none.
    double fluxAmps = 0.0;
    std::uint32_t seed = 1; ///< of the torques
    drive::UserLimits caps = {}; ///< the user's
    bool operator==(const SpinPlan &) const = default;
};

/// Between 0.25 and 0.7 of what is allowed, forwards; without a sensor from 0.4 on.
SpinPlan spinPlanFor(const Subject &subject, const drive::UserLimits &caps);

/// The same in the other direction. Behind it, it measures with it what one direction does not tell: a torque that is
/// always there.
SpinPlan otherWay(SpinPlan plan);

/// Faster, and with currents along the magnets: what inductances are measured by.
SpinPlan fluxPlanFor(const Subject &subject, const drive::UserLimits &caps);

/// Its fields by the names that recordings and files have them by.
template <class Field>
void eachField(SpinPlan &plan, Field &&field)
{
    field("low rpm", plan.lowRpm);
    field("high rpm", plan.highRpm);
    field("length ms", plan.length);
    field("flux A", plan.fluxAmps);
    field("approach ms", plan.approach);
    field("seed", plan.seed);
    field("max rpm", plan.caps.maxSpeedRpm);
    field("max A", plan.caps.maxCurrentAmps);
}

std::string objectionTo(const SpinPlan &plan, const Subject &subject);
Conditions conditionsOf(const SpinPlan &plan, const Subject &subject);
std::unique_ptr<Course> courseOf(const SpinPlan &plan, const Subject &subject);

/// Whether the entry was one.
bool usable(const Recorded<SpinPlan> &found);
/// Slower than this its rotor is as good as standing: a host that stalls while it coasts lets it stop. Electrical.
double leastTurning_degPerS(const Recorded<SpinPlan> &spin);

} // namespace lab
