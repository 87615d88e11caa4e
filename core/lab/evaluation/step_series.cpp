#include "lab/evaluation/step_series.h"

#include "lab/happenings.h"
#include "lab/maths/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace lab {

namespace {

/// The steps between the plan and the end of the series: set-points without a ramp, each until the next one.
class StepFinder {
public:
    explicit StepFinder(const Recorded<StepPlan> &plan)
        : m_plan(plan)
    {
    }
    void accept(Nanos at, const recorded::Happening &what)
    {
        if (what.name == "speed ramp")
            acceptRamp(at, what);
        else if (what.name == "motion" && what.field("act") == "SPEED_RAMP")
            acceptAnswer(what);
        else if (what.name == kEndEntry)
            acceptEnd(at, what);
        else if (what.name == "command" || what.name == "stop" || endsLink(what))
            leave(at);
    }
    std::vector<StepAsked> steps;
    std::string reason; ///< why it ended early; empty: it did not, or nothing says so
    bool over = false;

private:
    void acceptRamp(Nanos at, const recorded::Happening &what)
    {
        const auto motor = numberOf(what, "motor");
        const auto rpm = numberOf(what, "rpm");
        const auto ms = numberOf(what, "ms");
        const bool step = motor && rpm && ms && *motor == m_plan.motor && *ms == 0.0;
        if (!step || m_left)
            return leave(at);
        end(at);
        const StepPlan &plan = m_plan.plan;
        const bool up = *rpm == plan.toRpm;
        if (!up && *rpm != plan.fromRpm)
            return;
        const double from = up ? plan.fromRpm : plan.toRpm;
        const Nanos until = at + std::chrono::nanoseconds(plan.hold).count();
        steps.push_back({from, *rpm, at, at, until});
        m_open = true;
    }
    /// The motion log has when it was asked and answered, on the clock of the link.
    void acceptAnswer(const recorded::Happening &motion)
    {
        const auto asked = numberOf(motion, "asked s");
        const auto took = numberOf(motion, "took ms");
        if (!m_open || !asked || !took || *took < 0.0)
            return;
        StepAsked &step = steps.back();
        const Nanos at = capture::toNanos(*asked);
        if (std::abs(at - step.asked) > std::chrono::nanoseconds(std::chrono::seconds(1)).count())
            return;
        step.answered = std::max(step.asked, at + capture::toNanos(*took * 1e-3));
    }
    void acceptEnd(Nanos at, const recorded::Happening &what)
    {
        end(at);
        over = true;
        if (what.field("outcome") != "complete")
            reason = what.field("reason");
    }
    void end(Nanos at)
    {
        if (m_open)
            steps.back().until = std::min(steps.back().until, at);
        m_open = false;
    }

    /// Behind the last step the old set-point comes back, which may look like another one.
    void leave(Nanos at)
    {
        end(at);
        m_left = m_left || !steps.empty();
    }

    const Recorded<StepPlan> &m_plan;
    bool m_open = false; ///< the last step is still held
    bool m_left = false; ///< there will be no other one
};

/// Runs are what a recording has several of: one of these is a step.
std::string stepName(const MeasuredSteps &series, std::size_t run)
{
    return "step " + std::to_string(run + 1) + (series.runs[run].up ? " (up)" : " (down)");
}

/// The mean of one number of the steps; those that stand apart from the others of their direction are named.
std::optional<Estimate> meanOver(MeasuredSteps &series, std::optional<double> StepRun::*member,
    const std::string &what, double resolution)
{
    std::array<std::vector<double>, 2> values; // down, up
    for (const bool up : {false, true}) {
        std::vector<std::size_t> from;
        for (std::size_t i = 0; i < series.runs.size(); ++i) {
            const auto &value = series.runs[i].*member;
            if (series.runs[i].up != up || !value)
                continue;
            values[up].push_back(*value);
            from.push_back(i);
        }
        for (const std::size_t place : outliersOf(values[up], resolution))
            series.notes.push_back(stepName(series, from[place])
                + " stands apart from the others by its " + what + "; it is part of the mean");
    }
    return meanOfBoth(values[0], values[1]);
}

struct Number {
    std::optional<double> StepRun::*of;
    const char *name;
};
constexpr std::array kNumbers{Number{&StepRun::rise_s, "rise time"},
    Number{&StepRun::overshoot_pct, "overshoot"}, Number{&StepRun::settling_s, "settling time"},
    Number{&StepRun::peakIq_a, "peak current"}};

/// "one, two and three"
std::string listText(const std::vector<std::string> &names)
{
    std::string text = names.front();
    for (std::size_t i = 1; i < names.size(); ++i)
        text += (i + 1 < names.size() ? ", " : " and ") + names[i];
    return text;
}

/// Of how many steps a mean is, where that is not all: a sentence for all that are of as many.
void noteCounts(MeasuredSteps &series)
{
    std::map<std::size_t, std::vector<std::string>, std::greater<>> names;
    for (const Number &number : kNumbers) {
        const auto has = [&](const StepRun &run) { return (run.*number.of).has_value(); };
        names[static_cast<std::size_t>(std::ranges::count_if(series.runs, has))].emplace_back(
            number.name);
    }
    for (const auto &[count, of] : names)
        if (count > 0 && count < series.runs.size())
            series.notes.push_back("the mean " + listText(of)
                + (of.size() == 1 ? " is that of " : " are those of ") + std::to_string(count)
                + " of " + std::to_string(series.runs.size()) + " steps");
}

/// A step of few digits of the speed says little, also by the angle.
void noteResolution(StepSeries &series, const Recorded<StepPlan> &plan)
{
    constexpr double kLeastDigits = 20.0;
    const double step = std::abs(plan.plan.toRpm - plan.plan.fromRpm);
    if (plan.speedStepRpm > 0.0 && step < kLeastDigits * plan.speedStepRpm)
        series.notes.push_back("the step is only " + decimalText(step / plan.speedStepRpm, 3)
            + " digits of the set-point; " + decimalText(kLeastDigits * plan.speedStepRpm, 4)
            + " rpm or more say more");
}

/// @param told_s  the largest distance of steps that are told; 0: none is
void notePolls(StepSeries &series, double told_s)
{
    double distance_s = told_s;
    for (const StepRun &run : series.runs)
        distance_s = std::max(distance_s, run.tooFast && told_s == 0.0 ? run.pollDistance_s : 0.0);
    if (!(distance_s > 0.0))
        return;
    const std::string distance = decimalText(distance_s * 1e3, 2) + " ms";
    series.notes.push_back("the board records nothing: its speed was read once in up to " + distance
        + ", so that rise times are uncertain by as much, and peaks may be higher than is told");
    const auto tooFast = std::ranges::count_if(series.runs, &StepRun::tooFast);
    if (tooFast > 0)
        series.notes.push_back(std::to_string(tooFast) + " of " + std::to_string(series.runs.size())
            + " steps rise in less than three times the time between two of their values: nothing "
              "is told of them");
}

} // namespace

void takeAnswer(StepAsked &step, const recorded::Happening &motion)
{
    constexpr Nanos kSecond = 1'000'000'000;
    const auto asked = numberOf(motion, "asked s");
    const auto took = numberOf(motion, "took ms");
    if (asked && took)
        step.answered = std::clamp(capture::toNanos(*asked) + capture::toNanos(*took * 1e-3),
            step.asked, step.asked + kSecond);
}

void noteSeriesEnd(MeasuredSteps &series, bool over, const std::string &reason)
{
    if (!reason.empty())
        series.notes.push_back("the series ended early: " + reason);
    else if (!over)
        series.notes.emplace_back("the recording ends before the series does");
}

void addUncertainty(std::optional<Estimate> &mean, double by)
{
    if (!mean || !mean->low || !mean->high)
        return;
    *mean->low -= by;
    *mean->high += by;
}

void addMeans(MeasuredSteps &series, const StepResolution &resolution)
{
    series.rise_s = meanOver(series, &StepRun::rise_s, "rise time", resolution.rise_s);
    series.overshoot_pct = meanOver(series, &StepRun::overshoot_pct, "overshoot", 1.0);
    series.settling_s =
        meanOver(series, &StepRun::settling_s, "settling time", resolution.settling_s);
    series.peakIq_a =
        meanOver(series, &StepRun::peakIq_a, "peak current", 2.0 * resolution.digit_a);
    noteCounts(series);
}

void noteRuns(MeasuredSteps &series, const std::string &signal)
{
    constexpr std::ptrdiff_t kNamed = 3; // more of them are told by their number
    const auto settlesNot = [](const StepRun &run) {
        return !run.unusable && !run.tooFast && run.found && !run.settling_s;
    };
    const auto unsettled = std::count_if(series.runs.begin(), series.runs.end(), settlesNot);
    if (unsettled > kNamed)
        series.notes.push_back(std::to_string(unsettled) + " of "
            + std::to_string(series.runs.size()) + " steps do not settle while their " + signal
            + " is held");
    for (std::size_t i = 0; i < series.runs.size(); ++i) {
        const StepRun &run = series.runs[i];
        if (run.cut)
            series.notes.push_back(
                stepName(series, i) + " was cut short: nothing is told of its " + signal);
        else if (run.unusable == scope::WhyNot::GapInside)
            series.notes.push_back("samples are missing in " + stepName(series, i)
                + ": nothing is told of its " + signal);
        else if (run.unusable)
            series.notes.push_back(stepName(series, i) + " is not seen in the " + signal);
        else if (!run.found && run.instantError_s)
            series.notes.push_back("the instant of " + stepName(series, i) + " is uncertain by "
                + decimalText(*run.instantError_s * 1e3, 3) + " ms: its settling time is not told");
        else if (settlesNot(run) && unsettled <= kNamed)
            series.notes.push_back(
                stepName(series, i) + " does not settle while its " + signal + " is held");
        constexpr double kNoticeable = 0.02, kPercent = 100.0;
        if (run.atLimit > kNoticeable)
            series.notes.push_back("the current was at its limit in "
                + decimalText(run.atLimit * kPercent, 2) + " % of " + stepName(series, i)
                + ": it does not show the loop alone");
    }
}

Result<StepSeries, std::string> stepSeries(const capture::Capture &capture, const Happenings &all)
{
    const auto [plan, after] = planIn<StepPlan>(all);
    if (!plan)
        return fail(std::string("it is no recording of a series of steps"));
    StepFinder finder(*plan);
    for (auto at = after.begin(); at != after.end() && !finder.over; ++at)
        finder.accept(at->first, at->second);
    const bool polled = fastChannel(capture, plan->speed) == nullptr;
    const auto signal = [&](const std::string &name, std::string_view unit) {
        return polled ? polledChannel(capture, name, unit) : fastChannel(capture, name);
    };
    const StepChannels channels{fastChannel(capture, plan->reference), signal(plan->current, "A"),
        signal(plan->speed, "rpm"), signal(plan->angle, {})};
    if ((channels.reference == nullptr && !polled) || channels.speed == nullptr)
        return fail(std::string("it holds no samples of the signals of its series of steps"));
    StepSeries series;
    series.plan = plan->plan;
    const StepFacts facts{plan->polePairs, plan->regulator.proportional};
    const Nanos hold = std::chrono::nanoseconds(plan->plan.hold).count();
    for (const StepAsked &asked : finder.steps) {
        const auto cut = cutShort(asked, *channels.speed, hold);
        series.runs.push_back(cut ? *cut : evaluateStep(channels, asked, facts));
    }
    noteSeriesEnd(series, finder.over, finder.reason);
    noteResolution(series, *plan);
    noteRuns(series, "speed");
    constexpr double kMilli = 1e-3;
    // Of what the means are of: a step that was read too rarely takes nothing from the others.
    double distance_s = 0.0, error_s = 0.0;
    for (const StepRun &run : series.runs) {
        distance_s = std::max(distance_s, run.rise_s ? run.pollDistance_s : 0.0);
        error_s = std::max(error_s, run.settling_s ? run.instantError_s.value_or(0.0) : 0.0);
    }
    addMeans(series,
        {polled ? 0.0 : channels.reference->info().digit(), kMilli + distance_s,
            kMilli + distance_s});
    if (polled) {
        addUncertainty(series.rise_s, distance_s);
        addUncertainty(series.settling_s, error_s);
        notePolls(series, distance_s);
    }
    return series;
}

} // namespace lab
