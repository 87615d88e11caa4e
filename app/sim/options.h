// The command line of rotorscope-sim as values. It opens nothing.
#pragma once

#include "base/result.h"
#include "simulation/mcb/board.h"
#include "simulation/simulated_board.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

enum class Action : std::uint8_t {
    Serve,
    Help,
    ListProfiles,
    ListOptions,
    ListMotors,
    ListLiars,
    Describe
};

struct Served;

struct Options {
    Action action = Action::Serve;
    /// Makes what speaks the protocol that was named.
    Result<Served, std::string> (*serve)(const Options &options) = nullptr;
    simulation::BoardOptions board;
    simulation::McbBoardOptions mcb; ///< without its board, which is the one above
    std::string link; ///< path of a symbolic link to the pseudo-terminal; empty: none
    std::string rig; ///< path of the file that says what a static device is and holds
    std::optional<std::uint16_t> tcp; ///< number of the port; 0: a free one
    bool control = false; ///< obey words on standard input
};

/// @param words  the command line without the program's name
/// @return the options, or one sentence that says what to do
Result<Options, std::string> readOptions(const std::vector<std::string_view> &words);

std::string_view helpText();

} // namespace sim
