// Power and efficiency of a motor from a recording of it at one speed (lab/power_plan.h). Pure.
//
//   electrical = 3/2 (vd id + vq iq - V |i|)    V: what a bridge loses by its dead times, along the current
//   copper     = 3/2 R |i|^2
//   shaft      = (Kt iq + 3/2 p (Ld - Lq) id iq) w    what friction, fan and load take
#pragma once

#include "lab/evaluation/figures.h"
#include "lab/experiment.h"

namespace lab {

struct Power {
    static constexpr const char *kKind = "power";
    Figures figures; ///< speed_rpm, electrical_w, copper_w, shaft_w, efficiency
    std::vector<std::string> notes; ///< sentences without a full stop
};
inline const Figures &figuresOf(const Power &found) { return found.figures; }

/// The first such experiment in a recording; or why nothing follows from it, without a full stop.
Result<Power, std::string> evaluatePower(const capture::Capture &capture, const Happenings &all);

} // namespace lab
