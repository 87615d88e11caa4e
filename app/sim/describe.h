// What a simulated board is, as JSON: everything that its options come to, units in the names of the keys.
#pragma once

#include "simulation/simulated_board.h"

#include <string>

namespace sim {

/// One JSON object, ended by a newline. Its "machine" is what `--motor FILE` takes.
std::string describe(const simulation::BoardOptions &options);

} // namespace sim
