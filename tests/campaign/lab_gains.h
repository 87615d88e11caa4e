// Whether the gains that the lab proposes do what was promised, as a table.
#pragma once

#include "simulation/plant/parameters.h"

#include <cstdint>
#include <string>

namespace campaign {

/// Prints a row for each of four loads: none, four times the inertia, a fan, three times the dry friction. In each the
/// gains begin as the board has them, at four times of them, and at a quarter.
/// @return  cases that were as promised, of twelve a seed
int gainsOf(
    const std::string &motor, const simulation::PlantParameters &plant, std::uint64_t seeds);

} // namespace campaign
