#include "scope/trigger_condition.h"

#include <cmath>

namespace scope {

namespace {
using Fault = std::optional<ConditionError>;

Fault checkLevel(double level, double hysteresis)
{
    if (!std::isfinite(level) || !std::isfinite(hysteresis))
        return ConditionError::NotFinite;
    if (hysteresis < 0)
        return ConditionError::NegativeHysteresis;
    return std::nullopt;
}

Fault checkLevels(double low, double high, double hysteresis)
{
    if (!std::isfinite(low))
        return ConditionError::NotFinite;
    if (const Fault fault = checkLevel(high, hysteresis))
        return fault;
    if (!(low < high))
        return ConditionError::LevelsSwapped;
    return std::nullopt;
}

Fault checkDurations(const DurationTest &test)
{
    return test.least > test.most ? Fault(ConditionError::NoTime) : std::nullopt;
}

Fault checkType(const EdgeTrigger &edge) { return checkLevel(edge.level, edge.hysteresis); }
Fault checkType(const LevelTrigger &level) { return checkLevel(level.level, 0.0); }
Fault checkType(const WindowTrigger &window)
{
    return checkLevels(window.low, window.high, window.hysteresis);
}
Fault checkType(const PulseTrigger &pulse)
{
    const Fault fault = checkLevel(pulse.level, pulse.hysteresis);
    return fault ? fault : checkDurations(pulse.width);
}
Fault checkType(const SlewTrigger &slew)
{
    const Fault fault = checkLevels(slew.low, slew.high, slew.hysteresis);
    return fault ? fault : checkDurations(slew.time);
}
Fault checkType(const DropoutTrigger &dropout)
{
    const Fault fault = checkType(dropout.edge);
    return fault || dropout.time > 0 ? fault : ConditionError::NoTime;
}
Fault checkType(const NthEdgeTrigger &nth)
{
    if (const Fault fault = checkType(nth.edge))
        return fault;
    if (nth.idle < 0)
        return ConditionError::NoTime;
    return nth.count > 0 ? std::nullopt : Fault(ConditionError::NoCount);
}
Fault checkType(const EventTrigger & /*event*/) { return std::nullopt; }
} // namespace

std::optional<ConditionError> check(const TriggerCondition &condition)
{
    if (!std::isfinite(condition.turn) || condition.turn < 0)
        return ConditionError::NotFinite;
    return std::visit([](const auto &what) { return checkType(what); }, condition.what);
}

Between betweenSamples(const capture::ChannelInfo &info)
{
    return info.kind == capture::ChannelInfo::Kind::Fast ? Between::Line : Between::Hold;
}

} // namespace scope
