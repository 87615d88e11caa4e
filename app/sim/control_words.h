// The words that rotorscope-sim obeys on standard input, one a line.
#pragma once

#include "base/result.h"
#include "simulation/simulated_board.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace sim {

std::string_view trimmed(std::string_view text);
std::optional<std::uint64_t> number(std::string_view text, int base); ///< of 16 with or without 0x

enum class Obeyed : std::uint8_t { Done, Quit };

/// Does what one line says; an empty line does nothing. Otherwise one sentence that says what is wrong with it.
Result<Obeyed, std::string> obey(std::string_view line, simulation::SimulatedBoard &board);

/// The same for a device of a rig file, which knows `reset` and `quit`.
Result<Obeyed, std::string> obeyStatic(std::string_view line, const std::function<void()> &reset);

} // namespace sim
