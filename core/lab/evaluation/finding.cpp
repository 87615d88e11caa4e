#include "lab/evaluation/finding.h"

#include "lab/evaluation/current_response_evaluation.h"
#include "lab/evaluation/current_step_evaluation.h"

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

} // namespace

Result<Finding, std::string> findingIn(const capture::Capture &capture, const Happenings &all)
{
    for (const auto &[at, what] : all) {
        if (recordedPlan<StepPlan>(what))
            return found(Result<MeasuredSteps, std::string>(stepSeries(capture, all)));
        if (recordedPlan<CurrentStepPlan>(what))
            return found(currentSteps(capture, all));
        const auto spin = recordedPlan<SpinPlan>(what);
        if (recordedPlan<RestPlan>(what) || (spin && spin->plan.fluxAmps > 0.0))
            return found(evaluateElectrics(capture, all));
        if (spin)
            return found(evaluateMechanics(capture, all));
        if (const auto response = recordedPlan<ResponsePlan>(what))
            return response->plan.current != 0 ? found(evaluateCurrentResponse(capture, all))
                                               : found(evaluateResponse(capture, all));
    }
    return fail(std::string("it is no recording of an experiment"));
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
    if (const auto *electrics = std::get_if<Electrics>(&finding);
        electrics && !(electrics->rs_ohm && electrics->ld_h))
        return "not conclusive: not all of it could be measured";
    return {};
}

} // namespace lab
