#include "lab/plan_file.h"

#include "lab/caps.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

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

const double *numberIn(const PlanNumbers &numbers, std::string_view key)
{
    const auto found = std::find_if(
        numbers.begin(), numbers.end(), [key](const auto &number) { return number.first == key; });
    return found == numbers.end() ? nullptr : &found->second;
}

/// Takes the numbers of a file into the fields of a plan, as far as they can be meant: none is rounded or cut.
class TakeNumbers {
public:
    explicit TakeNumbers(const PlanNumbers &numbers)
        : m_numbers(numbers)
    {
    }
    void operator()(const char *name, double &value)
    {
        // 0 would bound nothing: a plan without a bound leaves the key out; so does one that does not know its motor.
        const std::string_view word = name;
        const bool bound = word.starts_with("max ") || word == "rs ohm" || word == "dead time V";
        if (const double *number = take(name, -kMost, kMost, false);
            number && bound && *number <= 0.0)
            m_wrong = m_keys.back();
        else if (number != nullptr)
            value = *number;
    }
    void operator()(const char *name, int &value)
    {
        const std::string_view word = name;
        const bool yesOrNo = word == "flux" || word == "current loop";
        // A plan with a proportional gain of 0 is one without gains: it leaves both keys out.
        const double least = yesOrNo ? 0.0 : word == "speed kp" ? 1.0 : -kMost;
        if (const double *number = take(name, least, yesOrNo ? 1.0 : kMost, true))
            value = static_cast<int>(*number);
    }
    void operator()(const char *name, std::uint32_t &value)
    {
        if (const double *number = take(name, 0.0, kMost, true))
            value = static_cast<std::uint32_t>(*number);
    }
    void operator()(const char *name, milliseconds &value)
    {
        if (const double *number = take(name, 0.0, kMost, true))
            value = milliseconds(static_cast<milliseconds::rep>(*number));
    }

    /// Those that the plan has.
    const std::vector<std::string> &keys() const { return m_keys; }
    /// The key of a number that cannot be meant; empty: none.
    const std::string &wrong() const { return m_wrong; }

private:
    static constexpr double kMost = 1e6; ///< rpm, A, ms: beyond everything that is carried out

    const double *take(const char *name, double least, double most, bool whole)
    {
        const double *number = numberIn(m_numbers, m_keys.emplace_back(keyOf(name)));
        const bool meant = number == nullptr
            || (*number >= least && *number <= most && (!whole || *number == std::round(*number)));
        if (!meant)
            m_wrong = m_keys.back();
        return meant ? number : nullptr;
    }

    const PlanNumbers &m_numbers;
    std::vector<std::string> m_keys;
    std::string m_wrong;
};

/// The numbers of the file over those of the usual plan.
/// @param needed  what the experiment has no usual number for
template <class Which>
Result<Plan, std::string> withNumbers(
    Which plan, const PlanNumbers &numbers, std::initializer_list<const char *> needed = {})
{
    TakeNumbers take(numbers);
    eachField(plan, take);
    const std::vector<std::string> &keys = take.keys();
    const auto unknown = std::find_if(numbers.begin(), numbers.end(), [&](const auto &number) {
        return std::find(keys.begin(), keys.end(), number.first) == keys.end();
    });
    if (unknown != numbers.end()) {
        std::string known;
        for (const std::string &one : keys)
            known.append(known.empty() ? "" : ", ").append(one);
        return fail("the key \"" + unknown->first + "\" is not known, its plan may have " + known);
    }
    if (!take.wrong().empty())
        return fail("its \"" + take.wrong() + "\" is no number that can be meant");
    for (const char *key : needed)
        if (numberIn(numbers, key) == nullptr)
            return fail("its plan needs \"" + std::string(key) + "\"");
    return Plan(plan);
}

/// Both gains or neither: the other one would be 0. An amplitude that is left out is that of the file's speed.
Result<Plan, std::string> responseWith(
    const ResponsePlan &usual, const PlanNumbers &numbers, const Subject &subject)
{
    const bool gains =
        numberIn(numbers, "speed_kp") != nullptr || numberIn(numbers, "speed_ki") != nullptr;
    auto plan =
        gains ? withNumbers(usual, numbers, {"speed_kp", "speed_ki"}) : withNumbers(usual, numbers);
    if (plan && numberIn(numbers, "amplitude_rpm") == nullptr) {
        auto &response = std::get<ResponsePlan>(*plan);
        response.amplitudeRpm = usualAmplitudeRpm(subject, response.rpm);
    }
    return plan;
}

/// Without a speed of its own it turns the way that the file's torques push.
Result<Plan, std::string> currentStepWith(
    const PlanNumbers &numbers, const Subject &subject, const drive::UserLimits &caps)
{
    const auto given = [&](const char *key) {
        const double *number = numberIn(numbers, key);
        return number != nullptr ? *number : 0.0;
    };
    return withNumbers(
        currentStepPlanFor(subject, given("flux") != 0.0, given("from_a"), given("to_a"), caps),
        numbers, {"from_a", "to_a"});
}

/// Of a file's bounds and the user's the lower ones count.
drive::UserLimits lowerOf(const PlanNumbers &numbers, const drive::UserLimits &caps)
{
    const auto lower = [&](const char *key, double own) {
        const double *number = numberIn(numbers, key);
        return number != nullptr && *number > 0.0 ? lowerKnown(*number, own) : own;
    };
    return {lower("max_rpm", caps.maxSpeedRpm), lower("max_a", caps.maxCurrentAmps)};
}

} // namespace

Result<Plan, std::string> planOf(const std::string &kind, const PlanNumbers &numbers,
    const Subject &subject, const drive::UserLimits &caps)
{
    const drive::UserLimits lower = lowerOf(numbers, caps);
    auto plan = [&]() -> Result<Plan, std::string> {
        if (kind == "step")
            return withNumbers(StepPlan{}, numbers, {"from_rpm", "to_rpm"});
        if (kind == "current_step")
            return currentStepWith(numbers, subject, lower);
        if (kind == "spin")
            return withNumbers(spinPlanFor(subject, lower), numbers);
        if (kind == "current_response")
            return responseWith(currentResponsePlanFor(subject, lower), numbers, subject);
        if (kind == "response")
            return responseWith(responsePlanFor(subject, lower), numbers, subject);
        if (kind == "rest")
            return withNumbers(restPlanFor(subject, lower), numbers);
        if (kind == "power")
            return withNumbers(powerPlanFor(subject, lower), numbers);
        if (kind == "load")
            return withNumbers(loadPlanFor(subject, lower), numbers);
        if (kind == "position")
            return withNumbers(PositionPlan{}, numbers, {"by_deg"});
        return fail("there is no experiment \"" + kind
            + "\", there are step, current_step, spin, rest, response, current_response, power, "
              "load and position");
    }();
    if (plan)
        std::visit([&](auto &of) { of.caps = lower; }, *plan);
    return plan;
}

} // namespace lab
