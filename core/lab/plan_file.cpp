#include "lab/plan_file.h"

#include "lab/caps.h"
#include "lab/plan_fields.h"

#include <algorithm>

namespace lab {

namespace {

std::string keyOf(const std::string &name)
{
    std::string key;
    for (const char letter : name)
        key += letter == ' '                 ? '_'
            : letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a')
                                             : letter;
    return key;
}

/// The fields of the file over those of the usual plan.
template <class Which>
Result<Plan, std::string> withNumbers(Which plan, const PlanNumbers &numbers)
{
    record::Happening names;
    putFields(names, plan);
    record::Happening wanted;
    for (const auto &number : numbers) {
        const std::string &key = number.first;
        const auto name = std::find_if(names.fields.begin(), names.fields.end(),
            [&](const auto &field) { return keyOf(field.first) == key; });
        if (name == names.fields.end())
            return fail("its plan has no \"" + key + "\"");
        wanted.fields.emplace_back(name->first, decimalText(number.second));
    }
    TakeFields take(wanted);
    eachField(plan, take);
    if (!take.wrong().empty())
        return fail("its \"" + keyOf(take.wrong()) + "\" is no number that can be meant");
    return Plan(plan);
}

} // namespace

Result<Plan, std::string> planOf(const std::string &kind, const PlanNumbers &numbers,
    const Subject &subject, const drive::UserLimits &caps)
{
    auto plan = [&]() -> Result<Plan, std::string> {
        if (kind == "step")
            return withNumbers(StepPlan{.caps = caps}, numbers);
        if (kind == "current_step")
            return withNumbers(currentStepPlanFor(subject, false, 0.0, 0.0, caps), numbers);
        if (kind == "spin")
            return withNumbers(spinPlanFor(subject, caps), numbers);
        if (kind == "current_response")
            return withNumbers(currentResponsePlanFor(subject, caps), numbers);
        if (kind == "response")
            return withNumbers(responsePlanFor(subject, caps), numbers);
        if (kind == "rest")
            return withNumbers(restPlanFor(subject, caps), numbers);
        return fail("there is no experiment \"" + kind + "\"");
    }();
    if (!plan)
        return plan;
    // Of a file's bounds and the user's the lower ones count.
    drive::UserLimits &own =
        std::visit([](auto &of) -> drive::UserLimits & { return of.caps; }, *plan);
    own = {lowerKnown(own.maxSpeedRpm, caps.maxSpeedRpm),
        lowerKnown(own.maxCurrentAmps, caps.maxCurrentAmps)};
    return plan;
}

} // namespace lab
