#include "lab/evaluation/position_evaluation.h"

#include "lab/evaluation/segments.h"
#include "scope/sample_range.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace lab {

namespace {

constexpr Nanos kBeforeMove = 50'000'000; ///< of a move, for where it begins
constexpr double kTail = 0.2; ///< of the time that a position is held, for where it ends

/// The moves between the plan and the end of the series.
class MoveFinder {
public:
    explicit MoveFinder(const Recorded<PositionPlan> &plan)
        : m_plan(plan)
        , m_whole(std::chrono::nanoseconds(plan.plan.ramp + plan.plan.hold).count())
    {
    }
    void accept(Nanos at, const recorded::Happening &what)
    {
        const bool ended = what.name == kEndEntry;
        if (m_open && what.name == "motion" && what.field("act") == "POSITION_RAMP")
            takeAnswer(moves.back(), what);
        if (what.name == "position ramp" && numberOf(what, "motor") == m_plan.motor)
            return acceptMove(at);
        if (!ended && what.name != "command" && what.name != "stop" && !endsLink(what))
            return;
        end(at);
        over = over || ended;
        if (ended && what.field("outcome") != "complete")
            reason = what.field("reason");
    }
    std::vector<StepAsked> moves;
    std::string reason; ///< why it ended early; empty: it did not, or nothing says so
    bool over = false;

private:
    void acceptMove(Nanos at)
    {
        end(at);
        const double by = m_plan.plan.byDegrees;
        const bool there = moves.size() % 2 == 0;
        moves.push_back({there ? 0.0 : by, there ? by : 0.0, at, at, at + m_whole});
        m_open = true;
    }
    void end(Nanos at)
    {
        if (m_open)
            moves.back().until = std::min(moves.back().until, at);
        m_open = false;
    }

    const Recorded<PositionPlan> &m_plan;
    Nanos m_whole;
    bool m_open = false; ///< the last one is still held
};

StepRun evaluateMove(const capture::Channel &angle, const capture::Channel *current,
    const StepAsked &asked, double polePairs)
{
    StepRun run;
    run.up = asked.to > asked.from;
    run.at = asked.asked + (asked.answered - asked.asked) / 2;
    run.until = asked.until;
    run.found = asked.answered > asked.asked;
    if (run.found)
        run.instantError_s = capture::toSeconds((asked.answered - asked.asked) / 2);
    if (current != nullptr)
        run.peakIq_a = peakOf(*current, run.at, asked.until);
    const capture::Capture moved = positionOf(angle, polePairs, run.at - kBeforeMove, asked.until);
    const auto channels = moved.channels();
    if (channels.empty())
        run.unusable = scope::WhyNot::GapInside;
    else
        measureStep(run, *moved.channel(channels.front().id), run.at - kBeforeMove, asked.until);
    return run;
}

/// Empty: there is no sample.
std::optional<double> meanIn(const capture::Channel &channel, Nanos from, Nanos to)
{
    double sum = 0.0, count = 0.0;
    scope::SampleRange(channel, from, to).visit([&](double, double value, bool) {
        sum += value;
        ++count;
    });
    return count > 0.0 ? std::optional(sum / count) : std::nullopt;
}

/// What friction leaves of a way, a loop without an integral part leaves.
void noteWay(MeasuredSteps &found, const capture::Channel &angle, const Recorded<PositionPlan> &of)
{
    constexpr double kShare = 0.02, kLeast_deg = 0.5;
    const double wanted = std::abs(of.plan.byDegrees);
    const auto tail = static_cast<Nanos>(
        kTail * static_cast<double>(std::chrono::nanoseconds(of.plan.hold).count()));
    double most = wanted, least = wanted;
    for (const StepRun &run : found.runs) {
        if (!run.settling_s)
            continue; // that is said already
        const capture::Capture moved =
            positionOf(angle, of.polePairs, run.at - kBeforeMove, run.until);
        const capture::Channel &position = *moved.channel(moved.channels().front().id);
        const auto before = meanIn(position, run.at - kBeforeMove, run.at),
                   after = meanIn(position, run.until - tail, run.until);
        if (!before || !after)
            continue;
        most = std::max(most, std::abs(*after - *before));
        least = std::min(least, std::abs(*after - *before));
    }
    const double off = most - wanted > wanted - least ? most : least;
    if (std::abs(off - wanted) > std::max(kLeast_deg, kShare * wanted))
        found.notes.push_back("the shaft moved by " + decimalText(off, 4) + " degrees instead of "
            + decimalText(wanted, 4) + " at the worst");
}

} // namespace

capture::Capture positionOf(const capture::Channel &angle, double polePairs, Nanos from, Nanos to)
{
    capture::Capture result;
    const std::vector<Segment> segments = segmentsOf(angle, {}, from, to);
    if (segments.size() != 1 || !(polePairs > 0.0)
        || !std::isfinite(segments.front().turned_deg.back()))
        return result;
    const Segment &segment = segments.front();
    double most = 1.0;
    for (const double turned : segment.turned_deg)
        most = std::max(most, std::abs(turned) / polePairs);
    capture::StreamLayout layout;
    layout.id = 1;
    layout.tickHz = 1.0 / segment.step_s;
    layout.originSeconds = capture::toSeconds(segment.at);
    const double digit = most / 32000.0;
    layout.fast = {{angle.info().registerId, "position from the angle", "\u00b0", digit}};
    capture::SampleBlock block;
    block.stream = layout.id;
    block.count = static_cast<std::uint32_t>(segment.turned_deg.size());
    for (const double turned : segment.turned_deg)
        block.fast.push_back(static_cast<std::int16_t>(std::lround(turned / polePairs / digit)));
    result.begin(layout);
    result.append(block);
    return result;
}

Result<MeasuredSteps, std::string> positionSteps(
    const capture::Capture &capture, const Happenings &all)
{
    const auto [plan, after] = planIn<PositionPlan>(all);
    if (!plan)
        return fail(std::string("it is no recording of moves of a shaft"));
    MoveFinder finder(*plan);
    for (auto at = after.begin(); at != after.end() && !finder.over; ++at)
        finder.accept(at->first, at->second);
    const capture::Channel *angle = fastChannel(capture, plan->angle);
    const capture::Channel *current = fastChannel(capture, plan->current);
    if (angle == nullptr)
        return fail(std::string("it holds no samples of the signals of its series of steps"));
    MeasuredSteps found;
    const Nanos hold = std::chrono::nanoseconds(plan->plan.hold).count(),
                ramp = std::chrono::nanoseconds(plan->plan.ramp).count();
    for (const StepAsked &asked : finder.moves) {
        const auto cut = cutShort(asked, *angle, hold, ramp);
        found.runs.push_back(cut ? *cut : evaluateMove(*angle, current, asked, plan->polePairs));
    }
    noteSeriesEnd(found, finder.over, finder.reason);
    noteRuns(found, "position");
    noteWay(found, *angle, *plan);
    constexpr double kMilli = 1e-3;
    double error_s = 0.0;
    for (const StepRun &run : found.runs)
        error_s = std::max(error_s, run.settling_s ? run.instantError_s.value_or(0.0) : 0.0);
    addMeans(found, {current != nullptr ? current->info().digit() : 0.0, kMilli, kMilli + error_s});
    addUncertainty(found.settling_s, error_s);
    return found;
}

} // namespace lab
