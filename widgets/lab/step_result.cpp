#include "widgets/lab/step_result.h"

#include "scope/sample_range.h"

#include <algorithm>

namespace widgets {
namespace {

using capture::Nanos;

constexpr Nanos kBefore = 20'000'000; ///< of the speed before a step
constexpr double kSpacing_s = 1e-3; ///< of the points that are drawn

/// What is drawn of a speed, and of which step.
void fill(StepCurve &curve, const capture::Channel &speed, Nanos at, Nanos until)
{
    const scope::SampleRange range(speed, at - kBefore, until);
    double next = 0.0;
    range.visit([&](double seconds, double rpm, bool) {
        if (seconds < next)
            return;
        next = seconds + kSpacing_s;
        curve.seconds.append(capture::toSeconds(range.toNanos(seconds) - at));
        curve.rpm.append(rpm);
    });
}

StepCurve curveOf(const capture::Capture &capture, const lab::Recorded<lab::StepPlan> &plan,
    const lab::StepRun &run, Nanos until)
{
    StepCurve curve;
    curve.up = run.up;
    const capture::Channel *angle = lab::fastChannel(capture, plan.angle);
    const capture::Channel *speed = lab::fastChannel(capture, plan.speed);
    if (angle != nullptr && run.speedWindow_s > 0.0) {
        const capture::Capture turned =
            lab::speedOf(*angle, plan.polePairs, run.speedWindow_s, run.at - kBefore, until);
        const auto channels = turned.channels();
        if (!channels.empty())
            fill(curve, *turned.channel(channels.front().id), run.at, until);
    } else if (speed != nullptr) {
        fill(curve, *speed, run.at, until);
    }
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

Result<StepResult, std::string> stepResult(const Experiments::Run &record, const std::string &bus)
{
    auto series = lab::stepSeries(record.capture, record.happenings);
    if (!series)
        return fail(series.error());
    StepResult result;
    result.series = std::move(*series);
    const auto plan = lab::recordedPlan<lab::StepPlan>(record.happenings.front().second);
    const auto &runs = result.series.runs;
    if (!plan || runs.empty())
        return result;
    const Nanos hold = std::chrono::nanoseconds(result.series.plan.hold).count();
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const Nanos next = i + 1 < runs.size() ? runs[i + 1].at : runs[i].at + hold;
        result.curves.append(
            curveOf(record.capture, *plan, runs[i], std::min(runs[i].at + hold, next)));
    }
    result.bus_v = extremesOf(record.capture, bus, runs.front().at, runs.back().at + hold);
    return result;
}

} // namespace widgets
