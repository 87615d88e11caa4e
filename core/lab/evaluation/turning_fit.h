// What the voltages of a turning motor tell of it. Pure.
//
// Along q in rotor coordinates, over slices of half a millisecond or some more, so that no noisy current is
// differentiated:
//   vq = R iq + Lq iq' + w Ld id + w0 flux cos(a) + what the dead time takes of each phase
// where w is the speed of the coordinates, w0 that of the rotor, and a how far the coordinates stand aside from it, but
// for a part that stays: flux cos(a) = flux (cos b + c1 b), of b = the part that changes. The equation along d would
// tell Lq with less noise, but of a board that observes its rotor it tells only what the observer believes: it turns
// its coordinates until that equation holds. The one along q hardly feels an angle that is off by a few degrees.
#pragma once

#include "lab/evaluation/turning_slices.h"
#include "lab/maths/statistics.h"

#include <optional>

namespace lab {

struct TurningFit {
    /// Their intervals hold the spread of the rows and what coordinates that stand aside change, no scale of voltage or
    /// current.
    Estimate ld_h, flux_wb;
    std::optional<Estimate> lq_h; ///< empty: nothing that a motor could have
    double swing_a = 0.0; ///< of a phase's current within a PWM period, zero to peak
    Estimate lost_v; ///< by the dead time, of a phase whose current does not swing through zero
};

struct Bridge {
    double bus_v = 0.0, nominal_a = 0.0; ///< of the motor, peak; both more than 0
};

/// Some 30 fits of a row in 2 ms and three of all, two a millisecond: 0.1 s for 12 s.
/// @param slices  as rotorSpeeds() left them, none without a slice
/// @param rs_ohm  as it was found at rest; empty: the one of these voltages, told apart badly from the dead time, is
/// good enough
/// @param allTellLq  not its jumps alone: the angle of Hall sensors jumps, and the currents with it; or samples are too
/// far apart
/// @return  empty if the rows do not tell them, or nothing that a motor could have
std::optional<TurningFit> turningFit(const std::vector<TurningSlices> &slices, const Bridge &bridge,
    std::optional<double> rs_ohm, bool allTellLq);

} // namespace lab
