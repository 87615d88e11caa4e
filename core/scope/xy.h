// One channel over another: the alpha-beta circle, the d-q vector, and the voltage that the inverter can reach.
#pragma once

#include "scope/sample_range.h"

#include <array>

namespace scope {

struct XyPoint {
    double x = 0.0; ///< in the unit of the first channel
    double y = 0.0; ///< in the unit of the second one
    /// Not joined to the point before it: a gap, or an angle that passed its end.
    bool first = false;
    Nanos time = 0;
};

struct XySettings {
    /// One turn of an angle on that axis, 0 for anything else: a step of more than half of it is not drawn as a line.
    double turnX = 0.0;
    double turnY = 0.0;
    std::size_t most = 20'000; ///< points at most, at least 2
};

struct XyTrace {
    std::vector<XyPoint> points; ///< oldest first
    std::size_t every = 1; ///< only each so many-th instant is in it
};

/// The pairs in [from, to): at the samples of whichever channel has more of them, the other one is worth what its
/// sample before says. Instants where one of them is not known are left out, and break the line, also if thinning out
/// skips them. Cost: one look at each sample of the faster channel.
XyTrace xyTrace(const capture::Channel &x, const capture::Channel &y, Nanos from, Nanos to,
    const XySettings &settings);

/// The corners of the voltages that six switches reach from a bus voltage, alpha first, counterclockwise; peak values
/// of a phase (Clarke that keeps amplitudes): 2/3 of the bus.
std::array<XyPoint, 6> voltageHexagon(double busVolts);

/// The largest circle inside it: what is reached without distortion, bus / sqrt 3.
double linearVoltage(double busVolts);

} // namespace scope
