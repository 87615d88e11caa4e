#include "lab/experiment.h"

#include "drive/motion_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace lab {

namespace {

using namespace std::chrono_literals;

constexpr milliseconds kLongest = 60s; ///< of what moves a motor by itself
constexpr milliseconds kReaching = 5s; ///< until a speed is that of the set-point, there and back

/// What a board that records nothing does not tell.
std::string objectionToReads(const Experiment &experiment)
{
    const Plan &plan = experiment.plan;
    const auto *response = std::get_if<ResponsePlan>(&plan);
    const bool told =
        std::holds_alternative<StepPlan>(plan) || std::holds_alternative<SpinPlan>(plan);
    if (experiment.subject.records() || told)
        return {};
    if (experiment.subject.polled)
        return "this board records nothing by itself: only steps of the speed, inertia and "
               "friction are told from values that are read one after the other";
    return response != nullptr && response->current == 0
        ? ""
        : "this board sends its samples once an exchange: only steps and response of the speed, "
          "inertia and friction are told from them";
}

std::string generalObjection(const Conditions &conditions, const Subject &subject)
{
    if (conditions.approach < 1ms || conditions.approach > 10s)
        return "the way to the first speed takes 1 ms to 10 s";
    const double allowed = drive::realBoundsOf(subject.limits, conditions.user).rpm;
    if (!(allowed > 0.0))
        return "nothing says how fast this motor may turn: give the greatest speed that it may "
               "have";
    const double highest = std::max(std::abs(conditions.leastRpm), std::abs(conditions.mostRpm));
    if (!(highest <= allowed))
        return std::to_string(std::lround(highest)) + " rpm are more than the "
            + std::to_string(std::lround(allowed)) + " rpm that are allowed";
    const bool turnsBack = conditions.leastRpm < 0.0 && conditions.mostRpm > 0.0;
    const double lowest =
        turnsBack ? 0.0 : std::min(std::abs(conditions.leastRpm), std::abs(conditions.mostRpm));
    const double observed = subject.leastObservedRpm(conditions.user.maxSpeedRpm);
    if (highest > 0.0 && lowest < observed)
        return "stay above " + std::to_string(std::lround(observed))
            + " rpm: this motor has no sensor, and at " + std::to_string(std::lround(lowest))
            + " rpm its rotor might be lost";
    // The envelope ends there: it would stop the motor in the middle. What is proposed has room for twice as much.
    if (highest > 0.0 && observed > 0.0 && lowest < observed + conditions.undershoot_rpm)
        return "keep both speeds at "
            + std::to_string(std::lround(observed + 2.0 * conditions.undershoot_rpm))
            + " rpm or above: this motor has no sensor, and a step to "
            + std::to_string(std::lround(lowest)) + " rpm goes on below the "
            + std::to_string(std::lround(observed)) + " rpm that are needed to see its rotor";
    return {};
}

} // namespace

milliseconds lengthOf(const Experiment &experiment)
{
    const Conditions conditions = conditionsOf(experiment);
    return 2 * (conditions.gently() + kReaching) + conditions.length;
}

std::string objectionTo(const Experiment &experiment)
{
    if (std::string why = objectionToReads(experiment); !why.empty())
        return why;
    const std::string own = std::visit(
        [&](const auto &plan) { return objectionTo(plan, experiment.subject); }, experiment.plan);
    if (!own.empty())
        return own;
    if (lengthOf(experiment) > kLongest)
        return "it could take " + std::to_string(lengthOf(experiment) / 1s)
            + " s, and what moves a motor by itself ends within " + std::to_string(kLongest / 1s)
            + " s: take fewer repetitions, or a shorter time for each";
    return generalObjection(conditionsOf(experiment), experiment.subject);
}

bool inBothDirections(const std::vector<Experiment> &all)
{
    const auto any = [&](auto meant) {
        return std::ranges::any_of(
            all, [&](const Experiment &one) { return meant(conditionsOf(one).firstRpm); });
    };
    return any([](int rpm) { return rpm > 0; }) && any([](int rpm) { return rpm < 0; });
}

std::string objectionWhileTurning(const Experiment &experiment, double before_rpm)
{
    const Conditions conditions = conditionsOf(experiment);
    if (conditions.beginning != Beginning::AtSpeed)
        return "the motor turns, and this is measured while it rests: stop it first";
    if (!conditions.lent.empty())
        return "the motor turns, and its gains are written while it rests: stop it first";
    if (conditions.travels)
        return "the motor turns, and its set-points can begin to leave with every exchange only "
               "while it rests: stop it first";
    // A ramp through 0 loses a rotor that is not seen there, and brakes all that turns with it.
    const bool steps = std::holds_alternative<StepPlan>(experiment.plan);
    if (before_rpm * conditions.firstRpm < 0.0 && !(steps && experiment.subject.seesRotor()))
        return "the motor turns the other way: stop it first";
    return {};
}

Conditions conditionsOf(const Experiment &experiment)
{
    return std::visit(
        [&](const auto &plan) { return conditionsOf(plan, experiment.subject); }, experiment.plan);
}

std::unique_ptr<Course> courseOf(const Experiment &experiment)
{
    return std::visit(
        [&](const auto &plan) { return courseOf(plan, experiment.subject); }, experiment.plan);
}

drive::Stream streamOf(const Experiment &experiment)
{
    drive::Stream stream;
    if (experiment.subject.polled)
        return stream;
    std::ranges::copy_if(conditionsOf(experiment).recorded, std::back_inserter(stream.fast),
        [](drive::RegisterId id) { return id != 0; });
    stream.fastEvery = experiment.subject.fastEvery(stream.fast.size());
    return stream;
}

drive::Watch watchOf(const Experiment &experiment)
{
    constexpr Duration kPolls = 20ms;
    const auto there = [](drive::RegisterId id) { return id != 0; };
    const Registers &registers = experiment.subject.registers;
    drive::Watch watch{.registers = {}, .period = kPolls};
    std::ranges::copy_if(std::array{registers.bus, registers.temperature},
        std::back_inserter(watch.registers), there);
    if (experiment.subject.polled)
        std::ranges::copy_if(
            conditionsOf(experiment).recorded, std::back_inserter(watch.drawn), there);
    watch.registers.insert(watch.registers.end(), watch.drawn.begin(), watch.drawn.end());
    return watch;
}

recorded::Happening entryOf(const Experiment &experiment, const SpeedRegulator &regulator)
{
    return std::visit(
        [&](const auto &plan) { return entryOf(plan, experiment.subject, regulator); },
        experiment.plan);
}

void addReason(Outcome &outcome, const std::string &reason)
{
    if (!outcome.reason.empty() && !reason.empty())
        outcome.reason += "; ";
    outcome.reason += reason;
}

Outcome inRow(const Outcome &before, const Outcome &last, bool more)
{
    Outcome all = last;
    if (before.shows && all.shows)
        all.shows->before_rpm = before.shows->before_rpm;
    all.leaves = before.leaves || last.leaves;
    all.reason = before.reason;
    addReason(all, last.reason);
    if (more && all.end == End::Complete && all.leaves) {
        all.end = End::Interrupted;
        addReason(all, "what comes next was not begun");
    }
    return all;
}

std::string shownText(const Outcome &outcome)
{
    const auto text = [](double rpm) { return std::to_string(std::lround(rpm)) + " rpm"; };
    const auto &shows = outcome.shows;
    if (!shows || text(shows->now_rpm) == text(shows->before_rpm))
        return {};
    return shows->name + " shows " + text(shows->now_rpm) + " until the next start, it showed "
        + text(shows->before_rpm);
}

recorded::Happening entryOfEnd(const Outcome &outcome)
{
    const char *how = outcome.end == End::Complete ? "complete" : "ended early";
    return {kEndEntry, {{"outcome", how}, {"reason", outcome.reason}}};
}

} // namespace lab
