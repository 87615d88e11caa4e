// The course by which the resistance of the windings is measured: currents of different strength through a motor that
// rests. One current would not do: what a bridge loses by its dead time hardly depends on the current, and would count
// as resistance.
//
// A board that sees its rotor holds them along the magnets, where they turn nothing. One that does not see it holds
// them in its start-up, whose stages are borrowed for that: none of them turns, and the motor is stopped before the
// last one is over.
#pragma once

#include "lab/course.h"
#include "lab/recorded_plan.h"

#include <string>

namespace lab {

struct RestPlan {
    static constexpr const char *kEntry = "rest plan"; ///< of its recording
    double lowAmps = 0.0, highAmps = 0.0; ///< the weakest and the strongest, peak
    milliseconds rise{200}; ///< from one to the next
    milliseconds hold{400};
    drive::UserLimits caps = {}; ///< the user's
    bool operator==(const RestPlan &) const = default;
};

/// A quarter and half of the nominal current, or less where less is allowed.
RestPlan restPlanFor(const Subject &subject, const drive::UserLimits &caps);

/// Its fields by the names that recordings and files have them by.
template <class Field>
void eachField(RestPlan &plan, Field &&field)
{
    field("low A", plan.lowAmps);
    field("high A", plan.highAmps);
    field("rise ms", plan.rise);
    field("hold ms", plan.hold);
    field("max rpm", plan.caps.maxSpeedRpm);
    field("max A", plan.caps.maxCurrentAmps);
}

std::string objectionTo(const RestPlan &plan, const Subject &subject);
Conditions conditionsOf(const RestPlan &plan, const Subject &subject);
std::unique_ptr<Course> courseOf(const RestPlan &plan, const Subject &subject);

/// Whether the entry was one.
bool usable(const Recorded<RestPlan> &found);

} // namespace lab
