// Resistance, dead time, inductances and flux from a recording of a motor at rest (lab/rest_plan.h) and of one that was
// accelerated and coasted with currents along its magnets (lab/spin_plan.h). Pure.
//
// At rest: the voltage along the current = R |i| + what the dead time takes. Its slope is the resistance.
//
// Turning, along q in rotor coordinates, integrated over slices of a millisecond, so that no noisy current is differentiated:
//   vq = R iq + Lq iq' + w Ld id + w0 flux + what the dead time takes of each phase
// where w is the speed of the coordinates and w0 that of the rotor (lab/evaluation/turning_slices.h). The equation along d would tell
// Lq with less noise, but of a board that observes its rotor it tells only what the observer believes: it turns its coordinates
// until that equation holds. The one along q hardly feels an angle that is off by a few degrees.
// R and the dead time are told apart badly there; they only keep out of the way of the others.
#pragma once

#include "lab/experiment.h"
#include "lab/happenings.h"
#include "lab/maths/estimate.h"

#include <string>
#include <vector>

namespace lab {

struct Electrics {
    std::optional<Estimate> rs_ohm; ///< of a phase, with the switches that carry its current
    std::optional<Estimate> deadTime_v;
    std::optional<Estimate> ld_h, lq_h, flux_wb;
    std::vector<std::string> notes; ///< sentences without a full stop
};

/// The first experiments of both kinds in a recording; or why there is none, or nothing follows from it, without a full stop.
Result<Electrics, std::string> evaluateElectrics(
    const capture::Capture &capture, const Happenings &all);

} // namespace lab
