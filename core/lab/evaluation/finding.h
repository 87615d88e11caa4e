// What a recording says of the experiments in it, whichever those were. Pure.
#pragma once

#include "lab/evaluation/electrical_evaluation.h"
#include "lab/evaluation/load_evaluation.h"
#include "lab/evaluation/mechanical_evaluation.h"
#include "lab/evaluation/power_evaluation.h"
#include "lab/evaluation/response_evaluation.h"
#include "lab/evaluation/step_series.h"

#include <variant>

namespace lab {

/// A response that is not of the speed is of a current.
using Finding = std::variant<MeasuredSteps, Mechanics, Electrics, SpeedResponse, FrequencyResponse,
    Power, LoadSteps>;

/// Where the runs of a recording begin. A run is what one command or one button of the window measures: an experiment,
/// or two that say one thing together: those of an electrical identification, at rest and turning, or of a mechanical
/// one in both directions.
class RunStarts {
public:
    /// In the order of the recording. @return  it is the plan that begins a run
    bool accept(const recorded::Happening &what);

private:
    /// The motor of the plan before, which was one at rest and did not end early; 0: none.
    int m_rested = 0;
    std::optional<Recorded<SpinPlan>> m_oneWay; ///< that, a mechanical one which began a run
};

/// Of each run what happened from its plan to that of the next one, in their order.
std::vector<Happenings> runsIn(const Happenings &all);
/// The command that measures the same, such as "step torque" or "identify electrical".
std::string nameOfRun(const Happenings &run);

/// Of the first run; or why there is none, or nothing follows from it, in a sentence without a full stop.
Result<Finding, std::string> findingIn(const capture::Capture &capture, const Happenings &all);

/// What the user has to know of it, sentences without a full stop.
const std::vector<std::string> &notesOf(const Finding &finding);

/// Why it is less than what was to be found, in a sentence without a full stop; empty: it is all of it.
std::string lackOf(const Finding &finding);

} // namespace lab
