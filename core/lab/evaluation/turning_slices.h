// A turning motor in slices of a millisecond, in the coordinates of the rotor as its board sees it: what the equations of its
// voltages are solved with. Pure.
#pragma once

#include "lab/evaluation/segments.h"

#include <vector>

namespace lab {

/// Means over a slice, and changes within it per second.
struct TurningSlice {
    double angle_rad = 0.0; ///< at its beginning, electrical, turns included
    double speed = 0.0; ///< rad/s electrical, of the coordinates
    double rotorSpeed = 0.0; ///< rad/s electrical, of the rotor; see rotorSpeeds()
    double q_a = 0.0, d_a = 0.0;
    double dq = 0.0; ///< A/s
    double lossQ = 0.0; ///< of the dead time, for each volt that a phase loses
    double q_v = 0.0;
};

/// Slices that follow one another without a gap.
struct TurningSlices {
    double step_s = 0.0;
    std::vector<TurningSlice> all;
};

/// @param segment  with Iq, Id and Vq as its values, in this order
/// @param small_a  below it a phase's current is taken for none: the dead time takes no whole volt from it
TurningSlices slicesOf(const Segment &segment, double small_a);

/// Fills in how fast the rotor itself turned. What a board observes of its rotor lags behind when the torque jumps, and so
/// do the coordinates; the rotor does what its inertia and its friction allow: within stretches of 50 ms its angle is
///   a Int(Int(iq)) + friction + b id, iq id, id^2, integrated twice + a straight line,
/// and what it is seen to stand aside with each current is kept apart from that. They are told by least squares over all
/// stretches; where they cannot be, the speed is that of the coordinates.
void rotorSpeeds(std::vector<TurningSlices> &slices);

} // namespace lab
