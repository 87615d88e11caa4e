#include "widgets/lab/step_result.h"

#include "scope/sample_range.h"

#include <algorithm>
#include <vector>

namespace widgets {
namespace {

using capture::Nanos;

constexpr Nanos kBefore = 20'000'000; ///< of the speed before a step
constexpr double kSpacing_s = 1e-3; ///< of the points that are drawn

/// What is drawn of a speed, and of which step.
void fill(StepCurve &curve, const capture::Channel &speed, const lab::StepRun &run)
{
    const Nanos at = run.at;
    const scope::SampleRange range(speed, at - kBefore, run.until);
    double next = 0.0;
    range.visit([&](double seconds, double rpm, bool joined) {
        if (joined && seconds < next)
            return;
        if (!joined && !curve.seconds.isEmpty())
            curve.gaps.append(curve.seconds.size());
        next = seconds + kSpacing_s;
        curve.seconds.append(capture::toSeconds(range.toNanos(seconds) - at));
        curve.rpm.append(rpm);
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
    for (const lab::StepRun &run : runs)
        result.curves.append(curveOf(record.capture, *plan, run));
    result.bus_v = extremesOf(record.capture, bus, runs.front().at, runs.back().at + hold);
    return result;
}

} // namespace widgets
