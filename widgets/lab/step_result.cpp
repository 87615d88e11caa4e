#include "widgets/lab/step_result.h"

#include "lab/evaluation/current_step_evaluation.h"
#include "lab/evaluation/position_evaluation.h"
#include "scope/sample_range.h"

#include <algorithm>
#include <vector>

namespace widgets {
namespace {

using capture::Nanos;

constexpr Nanos kBefore = 20'000'000; ///< of the speed before a step
constexpr double kSpacing_s = 1e-3; ///< of the points that are drawn
constexpr double kPoints = 500.0; ///< of a current while it is held

/// What is drawn of a signal, and of which step.
void fill(StepCurve &curve, const capture::Channel &signal, const lab::StepRun &run,
    Nanos before = kBefore, double spacing_s = kSpacing_s)
{
    const Nanos at = run.at;
    const scope::SampleRange range(signal, at - before, run.until);
    double next = 0.0;
    range.visit([&](double seconds, double value, bool joined) {
        if (joined && seconds < next)
            return;
        if (!joined && !curve.seconds.isEmpty())
            curve.gaps.append(curve.seconds.size());
        next = seconds + spacing_s;
        curve.seconds.append(capture::toSeconds(range.toNanos(seconds) - at));
        curve.values.append(value);
    });
}

/// [from, to) of the samples of a step between which none is missing.
std::vector<std::pair<Nanos, Nanos>> stretchesOf(
    const capture::Channel &channel, const lab::StepRun &run)
{
    std::vector<std::pair<Nanos, Nanos>> all;
    const scope::SampleRange range(channel, run.at - kBefore, run.until);
    const auto end = [&](capture::Index next) {
        if (!all.empty())
            all.back().second = channel.timeOf(next - 1) + 1;
    };
    capture::Index sample = range.begin();
    range.visit([&](double, double, bool joined) {
        if (!joined) {
            end(sample);
            all.emplace_back(channel.timeOf(sample), 0);
        }
        ++sample;
    });
    end(sample);
    return all;
}

StepCurve curveOf(const capture::Capture &capture, const lab::Recorded<lab::StepPlan> &plan,
    const lab::StepRun &run)
{
    StepCurve curve;
    curve.up = run.up;
    const capture::Channel *angle = lab::fastChannel(capture, plan.angle);
    const capture::Channel *speed = plan.reference.empty()
        ? lab::polledChannel(capture, plan.speed, "rpm")
        : lab::fastChannel(capture, plan.speed);
    if (angle != nullptr && run.speedWindow_s > 0.0) {
        for (const auto &[from, to] : stretchesOf(*angle, run)) {
            const capture::Capture turned =
                lab::speedOf(*angle, plan.polePairs, run.speedWindow_s, from, to);
            const auto channels = turned.channels();
            if (!channels.empty())
                fill(curve, *turned.channel(channels.front().id), run);
        }
    } else if (speed != nullptr) {
        fill(curve, *speed, run);
    }
    return curve;
}

/// @param hold  of each current
StepCurve curveOf(const capture::Channel &current, const lab::StepRun &run, Nanos hold)
{
    StepCurve curve;
    curve.up = run.up;
    fill(curve, current, run, hold / 2, capture::toSeconds(hold) / kPoints);
    return curve;
}

std::optional<std::pair<double, double>> extremesOf(
    const capture::Capture &capture, const std::string &name, Nanos from, Nanos to)
{
    for (const capture::ChannelInfo &info : capture.channels()) {
        if (name.empty() || info.name != name)
            continue;
        const capture::MinMax found =
            capture.extremes(info.id, capture::toSeconds(from), capture::toSeconds(to));
        if (!found.empty())
            return std::pair(double(found.min), double(found.max));
    }
    return std::nullopt;
}

} // namespace

bool StepResult::told() const
{
    return std::any_of(series.runs.begin(), series.runs.end(),
        [](const lab::StepRun &run) { return run.rise_s || run.peakIq_a; });
}

StepKind StepResult::kind() const
{
    if (position)
        return StepKind::Position;
    return !current ? StepKind::Speed : current->flux != 0 ? StepKind::Flux : StepKind::Torque;
}

namespace {

Result<StepResult, std::string> currentResult(
    const Experiments::Run &run, const lab::Recorded<lab::CurrentStepPlan> &plan)
{
    auto found = lab::currentSteps(run.capture, run.happenings);
    if (!found)
        return fail(found.error());
    StepResult result;
    static_cast<lab::MeasuredSteps &>(result.series) = std::move(*found);
    result.current = plan.plan;
    const capture::Channel *current =
        lab::fastChannel(run.capture, plan.plan.flux != 0 ? plan.currentD : plan.current);
    const Nanos hold = std::chrono::nanoseconds(plan.plan.hold).count();
    for (const lab::StepRun &step : result.series.runs)
        result.curves.append(curveOf(*current, step, hold)); // it is there: it was evaluated
    return result;
}

Result<StepResult, std::string> positionResult(
    const Experiments::Run &run, const lab::Recorded<lab::PositionPlan> &plan)
{
    auto found = lab::positionSteps(run.capture, run.happenings);
    if (!found)
        return fail(found.error());
    StepResult result;
    static_cast<lab::MeasuredSteps &>(result.series) = std::move(*found);
    result.position = plan.plan;
    const capture::Channel *angle = lab::fastChannel(run.capture, plan.angle);
    for (const lab::StepRun &step : result.series.runs) {
        StepCurve curve;
        curve.up = step.up;
        const capture::Capture moved =
            lab::positionOf(*angle, plan.polePairs, step.at - kBefore, step.until);
        if (const auto channels = moved.channels(); !channels.empty())
            fill(curve, *moved.channel(channels.front().id), step);
        result.curves.append(curve);
    }
    return result;
}

Result<StepResult, std::string> speedResult(const Experiments::Run &run)
{
    auto series = lab::stepSeries(run.capture, run.happenings);
    if (!series)
        return fail(series.error());
    StepResult result;
    result.series = std::move(*series);
    const auto plan = lab::recordedPlan<lab::StepPlan>(run.happenings.front().second);
    const auto &runs = result.series.runs;
    if (!plan || runs.empty())
        return result;
    for (const lab::StepRun &step : runs)
        result.curves.append(curveOf(run.capture, *plan, step));
    return result;
}

} // namespace

Result<StepResult, std::string> stepResult(const Experiments::Run &run, const std::string &bus)
{
    const recorded::Happening &begun = run.happenings.front().second;
    const auto current = lab::recordedPlan<lab::CurrentStepPlan>(begun);
    const auto position = lab::recordedPlan<lab::PositionPlan>(begun);
    auto result = current ? currentResult(run, *current)
        : position        ? positionResult(run, *position)
                          : speedResult(run);
    if (!result || result->series.runs.empty())
        return result;
    const auto &runs = result->series.runs;
    const std::chrono::milliseconds held = current ? current->plan.hold
        : position                                 ? position->plan.ramp + position->plan.hold
                                                   : result->series.plan.hold;
    result->bus_v = extremesOf(
        run.capture, bus, runs.front().at, runs.back().at + std::chrono::nanoseconds(held).count());
    return result;
}

} // namespace widgets
