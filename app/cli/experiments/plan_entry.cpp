#include "experiments/plan_entry.h"

#include "drive/values.h"
#include "motor_facts.h"

namespace cli {

Outcome<std::optional<lab::SpeedLoop>> readSpeedLoop(Desk &desk, const lab::Subject &subject)
{
    const std::vector<drive::RegisterId> ids = lab::gainRegisters(subject);
    if (ids.empty())
        return std::optional<lab::SpeedLoop>();
    const auto read = desk.talk.read(ids);
    if (!read)
        return tl::make_unexpected(read.error());
    const auto facts = readMotorFacts(desk);
    if (!facts)
        return tl::make_unexpected(facts.error());
    return lab::speedLoopOf(
        subject,
        [&](drive::RegisterId id) -> std::optional<double> {
            for (std::size_t at = 0; at < ids.size(); ++at)
                if (ids[at] == id)
                    return drive::asNumber((*read)[at].value);
            return std::nullopt;
        },
        facts->speedPeriod_s);
}

Outcome<recorded::Happening> entryOf(Desk &desk, const lab::Experiment &experiment)
{
    const bool bySpeed = std::holds_alternative<lab::StepPlan>(experiment.plan)
        || std::holds_alternative<lab::ResponsePlan>(experiment.plan);
    if (!bySpeed)
        return lab::entryOf(experiment, {});
    const auto loop = readSpeedLoop(desk, experiment.subject);
    if (!loop)
        return tl::make_unexpected(loop.error());
    if (!*loop)
        return lab::entryOf(experiment, {});
    const auto *response = std::get_if<lab::ResponsePlan>(&experiment.plan);
    return lab::entryOf(experiment,
        response != nullptr && response->kp > 0
            ? lab::withGains(**loop, response->kp, response->ki).regulator
            : (*loop)->regulator);
}

} // namespace cli
