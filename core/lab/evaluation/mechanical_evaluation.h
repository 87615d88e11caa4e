// Inertia and friction from a recording in which a motor was accelerated and left to coast (lab/spin_plan.h). Pure.
//
//   Kt iq = J w' + B w + Tc sgn w + F w|w|
//
// integrated inside stretches of a second, each from its own beginning, so that no noisy speed is differentiated:
//   Kt Int(iq) = J w + B angle + Tc t + F Int(w|w|) + c Int(iq^3) + constant of the stretch
// and solved by least squares, the impulse as the instrument of the speed: a speed has errors of its own, by Hall
// sensors large ones, and least squares alone would tell an inertia as much too small. Speed, angle and impulses are
// means over one window. The cube is what a board loses that takes the rotor for further than it is, the further the
// more current flows: the cosine of that angle. Boards that observe their rotor do. Source: shared practice of
// torque-step identification, as in Saarakkala and Hinkkanen, IEEE Trans. Ind. Appl. 51 (2015), doi
// 10.1109/TIA.2015.2416128, without its second mass.
#pragma once

#include "lab/experiment.h"
#include "lab/happenings.h"
#include "lab/maths/statistics.h"

#include <string>
#include <vector>

namespace lab {

struct Mechanics {
    Estimate inertia_kgm2, viscous_nms, dry_nm, fan_nms2;
    bool fan = false; ///< the model has one; else its interval says how large one might be
    double share = 0.0; ///< root mean square of what the model leaves, of the torque's
    std::vector<std::string> notes; ///< sentences without a full stop
};

/// The first such experiment in a recording; or why there is none, or nothing follows from it, without a full stop.
Result<Mechanics, std::string> evaluateMechanics(
    const capture::Capture &capture, const Happenings &asked);

} // namespace lab
