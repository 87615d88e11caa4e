// Moves of a shaft by an angle and back, by a board that controls positions: from where it rests, `repeat` times there
// and back, each within `ramp`, and held for `hold`. How such a board goes its way is its own matter.
#pragma once

#include "lab/course.h"
#include "lab/recorded_plan.h"

#include <string>

namespace lab {

struct PositionPlan {
    static constexpr const char *kEntry = "position plan"; ///< of its recording
    double byDegrees = 90.0; ///< mechanical, signed
    milliseconds ramp{300}; ///< of each move
    int repeat = 5; ///< moves there and as many back
    milliseconds hold{500}; ///< of each position
    drive::UserLimits caps = {}; ///< the user's
    bool operator==(const PositionPlan &) const = default;
};

/// Its fields by the names that recordings and files have them by.
template <class Field>
void eachField(PositionPlan &plan, Field &&field)
{
    field("by deg", plan.byDegrees);
    field("in ms", plan.ramp);
    field("repeat", plan.repeat);
    field("hold ms", plan.hold);
    field("max rpm", plan.caps.maxSpeedRpm);
    field("max A", plan.caps.maxCurrentAmps);
}

std::string objectionTo(const PositionPlan &plan, const Subject &subject);
Conditions conditionsOf(const PositionPlan &plan, const Subject &subject);
std::unique_ptr<Course> courseOf(const PositionPlan &plan, const Subject &subject);

/// Whether the entry was one.
bool usable(const Recorded<PositionPlan> &found);

} // namespace lab
