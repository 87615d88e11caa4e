// Motors that a simulated board can come with, each with an inverter that suits it. Constant tables.
#pragma once

#include "simulation/plant/parameters.h"

#include <span>
#include <string_view>

namespace simulation {

struct Preset {
    std::string_view name; ///< short, lower case, what `--motor` takes
    std::string_view summary; ///< one line for lists
    PlantParameters parameters;
};

/// All of them; the first is what a board has unless told otherwise.
std::span<const Preset> presets();

/// The preset of that name; nullptr if there is none.
const PlantParameters *findPreset(std::string_view name);

} // namespace simulation
