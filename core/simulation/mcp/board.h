// A board that speaks ST's protocol over ASPEP: its parts and their clock, behind the face of every simulated board.
#pragma once

#include "simulation/simulated_board.h"

namespace simulation {

/// @return  nullptr if there is no such profile or motor, or the motor cannot be
std::unique_ptr<SimulatedBoard> makeMcpBoard(const BoardOptions &options);

} // namespace simulation
