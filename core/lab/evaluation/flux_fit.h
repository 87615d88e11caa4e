// The flux of the magnets as the drive meets it, from voltages at many speeds:
//   vq = R iq + D + we flux
// over windows of 20 ms or more in which enough current flows for the voltage that dead times take to be a constant D. Where the
// board takes the rotor for elsewhere than it is, this is the flux times the cosine of that angle: what its torque follows.
// R and D only take up what is not the flux's: two levels of current do not tell them apart.
#pragma once

#include "lab/evaluation/segments.h"
#include "lab/maths/estimate.h"

#include <optional>

namespace lab {

inline constexpr double kFluxWindow_s = 20e-3;

/// @param segments  with Iq and Vq as their first two values
/// @param window_s  longer where the angle moves in steps: several of them are in it
/// @return  Wb; empty where the speed hardly varied. Its scale is that of the board's voltages, 1 to 2 %.
std::optional<Estimate> fitFlux(std::span<const Segment> segments, double window_s = kFluxWindow_s);

} // namespace lab
