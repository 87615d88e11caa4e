// One motor of the board: what is controlled and what controls it. Kept where it was made: its parts point at each
// other.
#pragma once

#include "simulation/firmware/firmware.h"
#include "simulation/plant/plant.h"
#include "simulation/simulated_board.h"

#include <memory>
#include <vector>

namespace simulation {

struct Axis {
    Axis(const PlantParameters &parameters, const Build &build, double hfHz, std::uint64_t seed)
        : Axis(parameters, build, designFor(parameters, hfHz, build.mainSensor), hfHz, seed)
    {
    }
    Axis(const PlantParameters &parameters, const Build &build, const DriveDesign &design,
        double hfHz, std::uint64_t seed)
        : plant(parameters, seed)
        , firmware(plant, build, design, hfHz)
    {
    }
    Axis(const Axis &) = delete;
    Axis &operator=(const Axis &) = delete;

    /// One control period: the motor moves on, then the firmware looks at it.
    void hfTask()
    {
        plant.advance(1.0 / firmware.hfHz());
        firmware.hfTask();
    }

    Plant plant;
    Firmware firmware;
};

/// One or two; motor 1 is the first.
using Axes = std::vector<std::unique_ptr<Axis>>;

/// What the motor does and what bounds it.
MotorTruth truthOf(const Axis &axis);
/// Of motor 1 or 2; at rest for one that is not there.
MotorTruth truthOf(const Axes &axes, int motor);

} // namespace simulation
