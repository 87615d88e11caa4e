// The words that rotorscope-sim obeys on standard input, one a line.
#pragma once

#include "base/result.h"
#include "simulation/simulated_board.h"

#include <string>
#include <string_view>

namespace sim {

enum class Obeyed : std::uint8_t { Done, Quit };

/// Does what one line says; an empty line does nothing. Otherwise one sentence that says what is wrong with it.
Result<Obeyed, std::string> obey(std::string_view line, simulation::SimulatedBoard &board);

} // namespace sim
