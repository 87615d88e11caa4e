// One motor of the board: what is controlled and what controls it. Kept where it was made: its parts point at each
// other.
#pragma once

#include "simulation/firmware/firmware.h"

#include <memory>
#include <vector>

namespace simulation {

struct Axis {
    Axis(double hfHz, std::uint64_t seed)
        : firmware(hfHz, seed)
    {
    }
    Axis(const Axis &) = delete;
    Axis &operator=(const Axis &) = delete;

    Firmware firmware;
};

/// One or two; motor 1 is the first.
using Axes = std::vector<std::unique_ptr<Axis>>;

} // namespace simulation
