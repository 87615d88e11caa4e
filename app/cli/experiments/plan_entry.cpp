#include "experiments/plan_entry.h"

#include "base/overloaded.h"
#include "drive/values.h"
#include "motor_facts.h"

namespace cli {

/// What closes the loop; its gains are 0 where the board does not tell them.
Outcome<lab::SpeedRegulator> regulatorOf(Desk &desk, const lab::Subject &subject)
{
    const lab::Registers &registers = subject.registers;
    const std::vector<drive::RegisterId> ids{
        registers.gain, registers.gainExponent, registers.integral, registers.integralExponent};
    lab::SpeedRegulator regulator;
    if (std::find(ids.begin(), ids.end(), 0U) != ids.end())
        return regulator;
    const auto read = desk.talk.read(ids);
    if (!read)
        return tl::make_unexpected(read.error());
    const auto gain = [&](std::size_t at) {
        const auto number = drive::asNumber((*read)[at].value);
        const auto exponent = drive::asNumber((*read)[at + 1].value);
        return number && exponent ? lab::jumpPerRpm(subject, *number, *exponent) : 0.0;
    };
    regulator.proportional = gain(0);
    regulator.integral = gain(2);
    const auto facts = readMotorFacts(desk, subject.motor);
    if (!facts)
        return tl::make_unexpected(facts.error());
    if (facts->speedPeriod_s > 0.0)
        regulator.period_s = facts->speedPeriod_s;
    return regulator;
}

Outcome<record::Happening> entryOf(Desk &desk, const lab::Experiment &experiment)
{
    const lab::Subject &subject = experiment.subject;
    using Entry = Outcome<record::Happening>;
    return std::visit(Overloaded{[&](const lab::StepPlan &plan) -> Entry {
                                     const auto regulator = regulatorOf(desk, subject);
                                     if (!regulator)
                                         return tl::make_unexpected(regulator.error());
                                     return lab::entryOf(plan, subject, regulator->proportional);
                                 },
                          [&](const lab::ResponsePlan &plan) -> Entry {
                              const auto regulator = regulatorOf(desk, subject);
                              if (!regulator)
                                  return tl::make_unexpected(regulator.error());
                              return lab::entryOf(plan, subject, *regulator);
                          },
                          [&](const auto &plan) -> Entry { return lab::entryOf(plan, subject); }},
        experiment.plan);
}

} // namespace cli
