#include "lab/evaluation/finding.h"

#include "lab/evaluation/current_response_evaluation.h"
#include "lab/evaluation/current_step_evaluation.h"
#include "lab/evaluation/position_evaluation.h"

namespace lab {
namespace {

using Found = Result<Finding, std::string>;

template <class T>
Found found(Result<T, std::string> result)
{
    if (!result)
        return fail(result.error());
    return Finding(std::in_place_type<T>, std::move(*result));
}

using Evaluation = Found (*)(const capture::Capture &, const Happenings &);
template <auto evaluate>
Found evaluated(const capture::Capture &capture, const Happenings &run)
{
    return found(evaluate(capture, run));
}
Found speedSteps(const capture::Capture &capture, const Happenings &run)
{
    return found(Result<MeasuredSteps, std::string>(stepSeries(capture, run)));
}

/// What a plan measures.
struct PlanKind {
    const char *name = "";
    Evaluation evaluation = nullptr; ///< nullptr: it is no plan
    int motor = 0;
    bool rests = false, turns = false; ///< of an electrical identification
};

PlanKind kindOf(const recorded::Happening &what)
{
    if (const auto steps = recordedPlan<StepPlan>(what))
        return {"step speed", speedSteps, steps->motor};
    if (const auto steps = recordedPlan<CurrentStepPlan>(what))
        return {steps->plan.flux != 0 ? "step flux" : "step torque", evaluated<currentSteps>,
            steps->motor};
    if (const auto response = recordedPlan<ResponsePlan>(what))
        return response->plan.current != 0
            ? PlanKind{"response current", evaluated<evaluateCurrentResponse>, response->motor}
            : PlanKind{"response speed", evaluated<evaluateResponse>, response->motor};
    if (const auto power = recordedPlan<PowerPlan>(what))
        return {"power", evaluated<evaluatePower>, power->motor};
    if (const auto load = recordedPlan<LoadPlan>(what))
        return {"step load", evaluated<evaluateLoad>, load->motor};
    if (const auto position = recordedPlan<PositionPlan>(what))
        return {"step position", evaluated<positionSteps>, position->motor};
    const auto rest = recordedPlan<RestPlan>(what);
    const auto spin = recordedPlan<SpinPlan>(what);
    if (spin && !(spin->plan.fluxAmps > 0.0))
        return {"identify mechanical", evaluated<evaluateMechanics>, spin->motor};
    if (rest || spin)
        return {.name = "identify electrical",
            .evaluation = evaluated<evaluateElectrics>,
            .motor = rest ? rest->motor : spin->motor,
            .rests = rest.has_value(),
            .turns = spin.has_value()};
    return {};
}

} // namespace

bool RunStarts::accept(const recorded::Happening &what)
{
    if (what.name == kEndEntry && what.field("outcome") != "complete") {
        m_rested = 0; // what would have turned it was not begun
        m_oneWay.reset();
    }
    const PlanKind plan = kindOf(what);
    if (plan.evaluation == nullptr)
        return false;
    const bool goesOn =
        (plan.turns && plan.motor == m_rested) || (m_oneWay && isOtherWay(what, *m_oneWay));
    m_rested = plan.rests ? plan.motor : 0;
    m_oneWay.reset();
    if (auto spin = recordedPlan<SpinPlan>(what); spin && !plan.turns && !goesOn)
        m_oneWay = std::move(spin);
    return !goesOn;
}

std::vector<Happenings> runsIn(const Happenings &all)
{
    std::vector<Happenings> runs;
    RunStarts starts;
    for (const auto &one : all) {
        if (starts.accept(one.second))
            runs.emplace_back();
        if (!runs.empty())
            runs.back().push_back(one);
    }
    return runs;
}

std::string nameOfRun(const Happenings &run)
{
    return run.empty() ? std::string() : kindOf(run.front().second).name;
}

Result<Finding, std::string> findingIn(const capture::Capture &capture, const Happenings &all)
{
    const std::vector<Happenings> runs = runsIn(all);
    if (runs.empty())
        return fail(std::string("it is no recording of an experiment"));
    const Happenings &run = runs.front();
    return kindOf(run.front().second).evaluation(capture, run);
}

const std::vector<std::string> &notesOf(const Finding &finding)
{
    return std::visit(
        [](const auto &one) -> const std::vector<std::string> & { return one.notes; }, finding);
}

std::string lackOf(const Finding &finding)
{
    if (const auto *steps = std::get_if<MeasuredSteps>(&finding); steps && !steps->rise_s)
        return "not conclusive: no step of this series could be measured";
    if (const auto *electrics = std::get_if<Electrics>(&finding); electrics
        && !(electrics->rs_ohm && electrics->ld_h && electrics->lq_h && electrics->flux_wb))
        return "not conclusive: not all of it could be measured";
    return {};
}

} // namespace lab
