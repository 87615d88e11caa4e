#include "lab/evaluation/current_step_evaluation.h"

#include "lab/happenings.h"
#include "scope/sample_range.h"

#include <algorithm>
#include <cmath>

namespace lab {

namespace {

/// The two steps of each repetition: behind them the motor coasts, and its speed is controlled again.
class CurrentStepFinder {
public:
    explicit CurrentStepFinder(const Recorded<CurrentStepPlan> &plan)
        : m_plan(plan)
    {
    }
    void accept(Nanos at, const recorded::Happening &what)
    {
        if (const auto amps = current(what))
            return acceptCurrent(at, *amps);
        const bool ended = what.name == kEndEntry;
        const std::string act = what.field("act");
        if (m_open && what.name == "motion" && (act == "TORQUE_RAMP" || act == "CURRENT_REFERENCE"))
            takeAnswer(steps.back(), what);
        if (!ended && what.name != "speed ramp" && what.name != "command" && what.name != "stop"
            && !endsLink(what))
            return;
        end(at);
        m_last.reset();
        m_group = 0;
        over = over || ended;
        if (ended && what.field("outcome") != "complete")
            reason = what.field("reason");
    }
    std::vector<StepAsked> steps;
    std::string reason; ///< why it ended early; empty: it did not, or nothing says so
    bool over = false;

private:
    /// Of the kind that is stepped.
    std::optional<double> current(const recorded::Happening &what) const
    {
        const bool flux = m_plan.plan.flux != 0;
        if (what.name != (flux ? "current reference" : "torque ramp")
            || numberOf(what, "motor") != m_plan.motor)
            return std::nullopt;
        return numberOf(what, flux ? "Id A" : "A");
    }
    void acceptCurrent(Nanos at, double amps)
    {
        constexpr int kSteps = 2;
        end(at);
        const CurrentStepPlan &plan = m_plan.plan;
        const bool there = m_last == plan.fromAmps && amps == plan.toAmps;
        const bool back = m_last == plan.toAmps && amps == plan.fromAmps;
        if ((there || back) && m_group < kSteps) {
            ++m_group;
            m_open = true;
            steps.push_back({*m_last, amps, at, at, at});
        }
        m_last = amps;
    }
    void end(Nanos at)
    {
        if (m_open)
            steps.back().until = at;
        m_open = false;
    }

    const Recorded<CurrentStepPlan> &m_plan;
    std::optional<double> m_last; ///< that was asked for
    int m_group = 0; ///< steps since the speed was controlled
    bool m_open = false; ///< the last step is still held
};

StepRun evaluate(const capture::Channel &reference, const capture::Channel &response,
    const capture::Channel *current, const StepAsked &asked, Nanos hold)
{
    StepRun run;
    run.up = asked.to > asked.from;
    const auto instant = stepInstant(reference, asked, 1.0);
    run.found = instant.has_value();
    run.at = instant ? instant->at : asked.asked;
    if (instant || asked.answered > asked.asked) // else nothing says when the board had it
        run.instantError_s =
            capture::toSeconds(instant ? instant->error : asked.answered - asked.asked);
    // The same of each, however late the host was.
    const Nanos until = std::min(asked.until, run.at + hold);
    run.until = until;
    if (current != nullptr)
        run.peakIq_a = peakOf(*current, run.at, until);
    if (run.found)
        measureStep(run, response, run.at - hold / 2, until);
    else
        run.unusable = scope::WhyNot::NoStep;
    return run;
}

/// Against that of the samples before a step.
void noteNoise(
    MeasuredSteps &found, const Recorded<CurrentStepPlan> &plan, const capture::Channel &response)
{
    constexpr double kNoticeable = 0.01, kPercent = 100.0;
    double squares = 0.0;
    double count = 0.0;
    const Nanos hold = std::chrono::nanoseconds(plan.plan.hold).count();
    for (const StepRun &run : found.runs) {
        if (run.cut)
            continue;
        const scope::SampleRange range(response, run.at - hold / 2, run.at);
        double before = 0.0;
        range.visit([&](double, double value, bool joined) {
            if (joined) { // of two that follow one another: what a step or a drift adds is small beside
                squares += (value - before) * (value - before) / 2.0;
                ++count;
            }
            before = value;
        });
    }
    const double noise =
        std::sqrt(squares / std::max(count, 1.0)) / std::abs(plan.plan.toAmps - plan.plan.fromAmps);
    if (noise > kNoticeable)
        found.notes.push_back("the noise of the measured current is "
            + decimalText(noise * kPercent, 2)
            + " % of the step: overshoot and settling are told from noise, too; a larger step says "
              "more");
}

} // namespace

Result<MeasuredSteps, std::string> currentSteps(
    const capture::Capture &capture, const Happenings &all)
{
    const auto [plan, after] = planIn<CurrentStepPlan>(all);
    if (!plan)
        return fail(std::string("it is no recording of a series of current steps"));
    CurrentStepFinder finder(*plan);
    for (auto at = after.begin(); at != after.end() && !finder.over; ++at)
        finder.accept(at->first, at->second);
    const bool flux = plan->plan.flux != 0;
    const capture::Channel *reference =
        fastChannel(capture, flux ? plan->referenceD : plan->reference);
    const capture::Channel *response = fastChannel(capture, flux ? plan->currentD : plan->current);
    if (reference == nullptr || response == nullptr)
        return fail(std::string("it holds no samples of the signals of its series of steps"));
    const capture::Channel *current = fastChannel(capture, plan->current);
    MeasuredSteps found;
    const Nanos hold = std::chrono::nanoseconds(plan->plan.hold).count();
    for (const StepAsked &asked : finder.steps) {
        const auto cut = cutShort(asked, *response, hold);
        found.runs.push_back(cut ? *cut : evaluate(*reference, *response, current, asked, hold));
    }
    noteSeriesEnd(found, finder.over, finder.reason);
    noteNoise(found, *plan, *response);
    noteRuns(found, "current");
    // Of the series: what was recorded before it may have had another rate.
    const capture::Index first =
        finder.steps.empty() ? reference->end() : reference->atOrAfter(finder.steps.front().asked);
    const Nanos sample =
        first < reference->end() ? reference->holdUntil(first) - reference->timeOf(first) : 0;
    const double sample_s = capture::toSeconds(sample);
    addMeans(found, {reference->info().digit(), sample_s, sample_s});
    return found;
}

} // namespace lab
