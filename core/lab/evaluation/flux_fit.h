// The flux of the magnets as the drive meets it, from voltages at many speeds:
//   vq = R iq + D + we flux_q
//   vd = -we Lq iq + we flux_d + ...
// over windows of 20 ms or more in which enough current flows for the voltage that dead times take to be a constant D.
// Where the board takes the rotor for elsewhere than it is, flux_q is the flux times the cosine of that angle, which
// its torque follows, and flux_d its sine. Dead times take nothing from vd, as no current flows along it, so that
// flux_d is the surer one. R, D and Lq only take up what is not the flux's: two levels of current do not tell them
// apart.
#pragma once

#include "lab/evaluation/segments.h"
#include "lab/maths/statistics.h"

#include <optional>

namespace lab {

inline constexpr double kFluxWindow_s = 20e-3;

/// Places of a segment's values; the last two may be missing.
enum FluxValue : std::size_t { kFluxIq, kFluxVq, kFluxVd, kFluxId };

/// Wb. Their scale is that of the board's voltages, 1 to 2 %.
struct FluxFit {
    Estimate q;
    std::optional<Estimate> d; ///< only of segments with Vd and Id
};

/// @param window_s  longer where the angle moves in steps: several of them are in it
/// @return  empty where the speed hardly varied, or without voltages
std::optional<FluxFit> fitFlux(std::span<const Segment> segments, double window_s = kFluxWindow_s);

/// How far the board takes its rotor to be ahead of where it is.
struct Aside {
    double cosine = 1.0, sine = 0.0;
    double unsure = 0.0; ///< share of the cosine
};

/// @param d_wb  of FluxFit
/// @param told_wb  the flux of the magnets as the board knows it
Aside asideOf(const Estimate &d_wb, double told_wb);

/// Iq becomes what flows across the magnets as they stand. While the speed changes some current flows along the board's
/// d axis, too: its loop follows a voltage that grows.
/// @param segments  with all four values
void turnCurrents(std::span<Segment> segments, const Aside &aside);

} // namespace lab
