// Resistance, dead time, inductances and flux from a recording of a motor at rest (lab/rest_plan.h) and of one that was
// accelerated and coasted with currents along its magnets (lab/spin_plan.h). Pure.
//
// At rest: the voltage along the current = R |i| + what the dead time takes. Its slope is the resistance.
//
// Turning: inductances and flux follow from the voltage along q (lab/evaluation/turning_fit.h).
#pragma once

#include "lab/evaluation/figures.h"
#include "lab/experiment.h"
#include "lab/happenings.h"
#include "lab/maths/statistics.h"

#include <string>
#include <vector>

namespace lab {

struct Electrics {
    static constexpr const char *kKind = "electrical";
    std::optional<Estimate> rs_ohm; ///< of a phase, with the switches that carry its current
    std::optional<Estimate> deadTime_v;
    std::optional<Estimate> ld_h, lq_h, flux_wb;
    std::vector<std::string> notes; ///< sentences without a full stop
};
Figures figuresOf(const Electrics &found);

/// The first experiments of both kinds in a recording; or why there is none, or nothing follows from it, without a full
/// stop.
Result<Electrics, std::string> evaluateElectrics(
    const capture::Capture &capture, const Happenings &all);

} // namespace lab
