// What the options of a board come to: its build and its machine, and the board of the protocol that its profile
// speaks.
#include "simulation/simulated_board.h"

#include "simulation/fcp/motor_board.h"
#include "simulation/mcb/board.h"
#include "simulation/mcp/board.h"
#include "simulation/plant/presets.h"

#include <algorithm>

namespace simulation {

Build buildOf(const BoardOptions &options)
{
    const auto asMade = [&] {
        return options.plant ? buildFor(options.profile, *options.plant)
                             : buildFor(options.profile, options.motor);
    };
    Build build = options.build ? *options.build : asMade();
    for (const BuildOption *option : options.with)
        addOption(build, *option);
    build.motors = std::clamp(options.motors, 1, 2);
    return build;
}

std::optional<PlantParameters> plantOf(const BoardOptions &options)
{
    const PlantParameters *preset =
        options.motor.empty() ? &presets().front().parameters : findPreset(options.motor);
    if (!options.plant && preset == nullptr)
        return std::nullopt;
    constexpr int kPulses = 1000;
    const Build build = buildOf(options);
    PlantParameters plant = options.plant ? *options.plant : *preset;
    if (options.load)
        plant.load = *options.load;
    if (build.encoder && plant.sensors.encoderPulses == 0)
        plant.sensors.encoderPulses = kPulses;
    plant.sensors.hall = plant.sensors.hall || build.hall;
    if (!impossibleParameter(plant).empty())
        return std::nullopt;
    return plant;
}

std::unique_ptr<SimulatedBoard> makeBoard(const BoardOptions &options)
{
    if (isFcpProfile(options.profile))
        return makeFcpBoard(options);
    if (options.profile == kServoProfile) {
        McbBoardOptions servo;
        servo.board = options;
        return makeMcbBoard(std::move(servo));
    }
    return makeMcpBoard(options);
}

} // namespace simulation
