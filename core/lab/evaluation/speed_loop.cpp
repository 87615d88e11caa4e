#include "lab/evaluation/speed_loop.h"

#include <algorithm>

namespace lab {

std::vector<drive::RegisterId> gainRegisters(const Subject &subject)
{
    const Registers &registers = subject.registers;
    std::vector<drive::RegisterId> all{
        registers.gain, registers.gainExponent, registers.integral, registers.integralExponent};
    if (std::find(all.begin(), all.end(), 0U) != all.end())
        all.clear();
    return all;
}

std::optional<SpeedLoop> speedLoopOf(
    const Subject &subject, const Numbers &numbers, double period_s)
{
    const std::vector<drive::RegisterId> registers = gainRegisters(subject);
    std::vector<double> known;
    for (const drive::RegisterId id : registers)
        if (const auto number = numbers(id))
            known.push_back(*number);
    if (registers.empty() || known.size() != registers.size())
        return std::nullopt;
    SpeedLoop loop;
    loop.digits.proportional = jumpPerRpm(subject, 1.0, known[1]);
    loop.digits.integral = jumpPerRpm(subject, 1.0, known[3]);
    if (period_s > 0.0)
        loop.regulator.period_s = period_s;
    return withGains(loop, static_cast<int>(known[0]), static_cast<int>(known[2]));
}

SpeedLoop withGains(SpeedLoop loop, int proportional, int integral)
{
    loop.proportional = proportional;
    loop.integral = integral;
    loop.regulator.proportional = proportional * loop.digits.proportional;
    loop.regulator.integral = integral * loop.digits.integral;
    return loop;
}

std::optional<ResponsePlan> calmer(ResponsePlan plan, const SpeedLoop &loop)
{
    constexpr int kPart = 4, kLeast = 8; // digits; below, a gain is coarse
    const bool own = plan.kp > 0;
    plan.kp = (own ? plan.kp : loop.proportional) / kPart;
    plan.ki = (own ? plan.ki : loop.integral) / kPart;
    return plan.kp >= kLeast ? std::optional(plan) : std::nullopt;
}

std::vector<drive::RegisterWrite> gainWrites(const Subject &subject, int proportional, int integral)
{
    return {{subject.registers.gain, std::int64_t{proportional}},
        {subject.registers.integral, std::int64_t{integral}}};
}

StepPlan proofStepsFor(const Subject &subject, const drive::UserLimits &caps)
{
    constexpr int kStep_rpm = 200, kRepeats = 5;
    const int from = responsePlanFor(subject, caps).rpm;
    return {.fromRpm = from, .toRpm = from + kStep_rpm, .repeat = kRepeats, .caps = caps};
}

} // namespace lab
