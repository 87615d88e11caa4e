#include "lab/caps.h"

#include <algorithm>

namespace lab {

namespace {

/// Of the greatest speed that a board tells: its own loop overshoots there.
constexpr double kAboveBoard = 1.1;

} // namespace

double lowerKnown(double one, double other)
{
    return one > 0.0 && other > 0.0 ? std::min(one, other) : std::max(one, other);
}

double allowedRpm(const Experiment &experiment)
{
    return lowerKnown(experiment.subject.limits.maxSpeedRpm * kAboveBoard,
        conditionsOf(experiment).user.maxSpeedRpm);
}

/// A motor on its way to its speed passes 0 and the speed it had.
Caps capsOf(const Experiment &experiment, double before_rpm)
{
    const Conditions conditions = conditionsOf(experiment);
    const double first = conditions.firstRpm, allowed = allowedRpm(experiment);
    Caps caps;
    caps.leastRpm = std::min({conditions.leastRpm, first, before_rpm}) - conditions.margin_rpm;
    caps.mostRpm = std::max({conditions.mostRpm, first, before_rpm}) + conditions.margin_rpm;
    caps.leastRpm = std::max(caps.leastRpm, -allowed);
    caps.mostRpm = std::min(caps.mostRpm, allowed);
    // What the board can measure is often far above what its motor stands.
    const drive::MotorLimits &board = experiment.subject.limits;
    if (experiment.subject.registers.current == 0)
        return caps; // nothing tells a current that could be held against a bound
    caps.mostAmps =
        lowerKnown(lowerKnown(board.maxCurrentAmps, board.nominalCurrentAmps) * kCurrentAboveBoard,
            conditions.user.maxCurrentAmps);
    return caps;
}

CurrentBound currentBoundOf(const Experiment &experiment)
{
    const double most = capsOf(experiment, 0.0).mostAmps;
    const drive::MotorLimits &board = experiment.subject.limits;
    if (!(most > 0.0))
        return CurrentBound::None;
    if (most == conditionsOf(experiment).user.maxCurrentAmps)
        return CurrentBound::User;
    return most == board.nominalCurrentAmps * kCurrentAboveBoard ? CurrentBound::Nominal
                                                                 : CurrentBound::Board;
}

bool covers(const Caps &agreed, const Caps &wanted)
{
    // Zero bounds nothing.
    const bool amps =
        !(agreed.mostAmps > 0.0) || (wanted.mostAmps > 0.0 && wanted.mostAmps <= agreed.mostAmps);
    return amps && wanted.leastRpm >= agreed.leastRpm && wanted.mostRpm <= agreed.mostRpm;
}

Agreement agreementTo(const Experiment &experiment, double before_rpm)
{
    const auto *spin = std::get_if<SpinPlan>(&experiment.plan);
    const auto *step = std::get_if<CurrentStepPlan>(&experiment.plan);
    const bool flux =
        (spin != nullptr && spin->fluxAmps != 0.0) || (step != nullptr && step->flux != 0);
    const auto *position = std::get_if<PositionPlan>(&experiment.plan);
    const double by = position != nullptr ? position->byDegrees : 0.0;
    return {experiment.plan.index(), flux, capsOf(experiment, before_rpm), lengthOf(experiment),
        conditionsOf(experiment).lent, std::min(by, 0.0), std::max(by, 0.0)};
}

bool covers(const Agreement &agreed, const Agreement &wanted)
{
    const bool lent = wanted.lent.empty() || wanted.lent == agreed.lent;
    const bool way =
        wanted.leastDegrees >= agreed.leastDegrees && wanted.mostDegrees <= agreed.mostDegrees;
    return agreed.kind == wanted.kind && agreed.flux == wanted.flux && way
        && wanted.length <= agreed.length && lent && covers(agreed.caps, wanted.caps);
}

} // namespace lab
