// Inertia and friction from a recording in which a motor was accelerated and left to coast (lab/spin_plan.h). Pure.
//
//   Kt iq = J w' + B w + Tc sgn w + F w|w|
//
// integrated inside stretches of a second, each from its own beginning, so that no noisy speed is differentiated:
//   Kt Int(iq) = J w + B angle + Tc t + F Int(w|w|) + c Int(iq^3) + constant of the stretch
// and solved by least squares, the impulse as the instrument of the speed: a speed has errors of its own, by Hall
// sensors large ones, and least squares alone would tell an inertia as much too small. Speed, angle and impulses are
// means over one window. The cube is what a board loses that takes the rotor for further than it is, the further the
// more current flows: the cosine of that angle. Boards that observe their rotor do. A run in both directions has one
// more, T0 t: a torque that is always there, as of a weight or of a current that is measured beside its zero, which one
// direction takes for friction. Source: shared practice of torque-step identification, as in Saarakkala and Hinkkanen,
// IEEE Trans. Ind. Appl. 51 (2015), doi 10.1109/TIA.2015.2416128, without its second mass.
#pragma once

#include "lab/happenings.h"
#include "lab/maths/statistics.h"
#include "lab/recorded_plan.h"
#include "lab/spin_plan.h"

#include <optional>
#include <string>
#include <vector>

namespace lab {

/// What a motor that was driven forwards and backwards tells besides.
struct BothWays {
    Estimate forwards_kgm2, backwards_kgm2; ///< the inertia by one direction alone
    Estimate always_nm; ///< T0: above 0 it hinders it forwards, and drives it backwards
};

struct Mechanics {
    Estimate inertia_kgm2, viscous_nms, dry_nm, fan_nms2;
    bool fan = false; ///< the model has one; else its interval says how large one might be
    std::optional<BothWays> both; ///< empty: it was driven in one direction
    double share = 0.0; ///< root mean square of what the model leaves, of the torque's
    std::vector<std::string> notes; ///< sentences without a full stop
};

/// Whether that is the plan of the other direction, which measures one thing together with this one.
bool isOtherWay(const recorded::Happening &what, const Recorded<SpinPlan> &of);

/// The first such experiment in a recording, with its otherWay() if that is behind it; or why there is none, or nothing
/// follows from it, without a full stop.
Result<Mechanics, std::string> evaluateMechanics(
    const capture::Capture &capture, const Happenings &asked);

} // namespace lab
