// The flux of the magnets as the drive meets it, from voltages at many speeds:
//   vq = R iq + D + we flux
// over windows of 20 ms in which enough current flows for the voltage that dead times take to be a constant D. Where the
// board takes the rotor for elsewhere than it is, this is the flux times the cosine of that angle: what its torque follows.
// R and D only take up what is not the flux's: two levels of current do not tell them apart.
#pragma once

#include "lab/evaluation/segments.h"
#include "lab/maths/estimate.h"

#include <optional>

namespace lab {

/// @param segments  with Iq and Vq as their first two values
/// @return  Wb; empty where the speed hardly varied. Its scale is that of the board's voltages, 1 to 2 %.
std::optional<Estimate> fitFlux(std::span<const Segment> segments);

} // namespace lab
