// How a speed loop takes a load that comes or goes, from a recording of a speed that is held (lab/load_plan.h). Pure.
//
// A change is where the speed leaves its noise; it is over when the speed stays within a tenth of its way again. The
// load is the difference of the current's reference before and behind it.
#pragma once

#include "lab/evaluation/figures.h"
#include "lab/experiment.h"

namespace lab {

struct LoadSteps {
    static constexpr const char *kKind = "load";
    /// load_a, load_nm, dip_rpm, dip_rpm_per_a, recovery_s: means over the changes, those that come and those that go
    /// alike; peak_iq_a: the largest of all
    Figures figures;
    std::vector<std::string> notes; ///< sentences without a full stop
};
inline const Figures &figuresOf(const LoadSteps &found) { return found.figures; }

/// The first such experiment in a recording; or why nothing follows from it, without a full stop.
Result<LoadSteps, std::string> evaluateLoad(const capture::Capture &capture, const Happenings &all);

} // namespace lab
