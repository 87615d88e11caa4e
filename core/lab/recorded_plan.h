// A plan as an entry of its recording, and back: its motor, its fields, and what it has to know of the speed loop.
#pragma once

#include "lab/happenings.h"
#include "lab/plan_fields.h"
#include "lab/recorded_motor.h"

#include <optional>
#include <utility>

namespace lab {

/// What the speed regulator does: reference of Iq = proportional x error + integral x sum of errors, once a period.
struct SpeedRegulator {
    double proportional = 0.0, integral = 0.0; ///< A/rpm
    double period_s = 1e-3;
    bool operator==(const SpeedRegulator &) const = default;
};

template <class Plan>
struct Recorded : RecordedMotor {
    Plan plan;
    SpeedRegulator regulator; ///< as far as the entry has it
};

/// The fields of the regulator in the entry of a plan: none, but where a plan says which.
template <class Plan, class Field>
void eachGain(const Plan &, SpeedRegulator &, Field &&)
{
}

template <class Plan>
recorded::Happening entryOf(const Plan &plan, const Subject &subject, SpeedRegulator regulator)
{
    recorded::Happening entry{Plan::kEntry, {}};
    putMotor(entry, subject);
    putFields(entry, plan);
    eachGain(plan, regulator, PutFields(entry));
    return entry;
}

/// Empty for any other entry, or one that is no plan.
template <class Plan>
std::optional<Recorded<Plan>> recordedPlan(const recorded::Happening &entry)
{
    if (entry.name != Plan::kEntry)
        return std::nullopt;
    Recorded<Plan> found{recordedMotor(entry), {}, {}};
    eachField(found.plan, TakeFields(entry));
    eachGain(found.plan, found.regulator, TakeFields(entry));
    return found.motor >= 1 && usable(found) ? std::optional(found) : std::nullopt;
}

/// The first such plan of a recording, and what was carried out after it.
template <class Plan>
std::pair<std::optional<Recorded<Plan>>, Happenings> planIn(const Happenings &all)
{
    Happenings after = carriedOut(all);
    std::optional<Recorded<Plan>> found;
    auto at = after.begin();
    for (; at != after.end() && !found; ++at)
        found = recordedPlan<Plan>(at->second);
    after.erase(after.begin(), at);
    return {found, std::move(after)};
}

} // namespace lab
