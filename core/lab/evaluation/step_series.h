// What a recording says of a series of steps: every run, and what they have in common. Pure: the same recording gives
// the same numbers, on the day of the measurement and a year later.
#pragma once

#include "lab/evaluation/step_evaluation.h"
#include "lab/experiment.h"
#include "lab/happenings.h"
#include "lab/maths/statistics.h"

#include <string>
#include <vector>

namespace lab {

struct MeasuredSteps {
    std::vector<StepRun> runs; ///< in the order in which they were made
    /// In the middle between the mean of the steps up and that of the steps down, of all runs that have it.
    std::optional<Estimate> rise_s, overshoot_pct, settling_s, peakIq_a;
    /// What the user has to know of these numbers, a sentence each, without a full stop.
    std::vector<std::string> notes;
};
struct StepSeries : MeasuredSteps {
    StepPlan plan;
};

/// Takes when the board had it from the motion log, which has when it was asked and answered, on the clock of the link.
void takeAnswer(StepAsked &step, const recorded::Happening &motion);
/// Says why a series is not whole. @param reason  why it ended early; empty: nothing says so
void noteSeriesEnd(MeasuredSteps &series, bool over, const std::string &reason);

/// Differences up to it are none.
struct StepResolution {
    double digit_a = 0.0, rise_s = 0.0, settling_s = 0.0;
};
/// Their means, with notes on steps that stand apart from the others and on means that are not of all.
void addMeans(MeasuredSteps &series, const StepResolution &resolution);
/// Of values that were read one after the other, or counted from an instant that is not quite known: to all of it,
/// however many steps say the same, because host and board may be in step.
void addUncertainty(std::optional<Estimate> &mean, double by);
/// Notes on steps of which not all is told. @param signal  what is stepped, in a word
void noteRuns(MeasuredSteps &series, const std::string &signal);

/// The first series in a recording; or why there is none, in a sentence without a full stop.
Result<StepSeries, std::string> stepSeries(const capture::Capture &capture, const Happenings &all);

} // namespace lab
