// A simulated board of the older serial protocol with one or two motors that turn: the plant and the firmware of the
// other simulated boards behind the registers of this protocol.
//
// Profiles: "legacy" behaves as firmware 5.4.3, "legacy-text" as its printed description (frames that take longer than
// 25 ms are refused, GET_BOARD_INFO has integers), "powerpc" as the description of that dialect.
#pragma once

#include "simulation/simulated_board.h"

#include <memory>
#include <string_view>
#include <vector>

namespace simulation {

/// A board of one of fcpProfiles(); nullptr if the profile or the motor is none, or the motor cannot be.
std::unique_ptr<SimulatedBoard> makeFcpBoard(const BoardOptions &options);

std::vector<std::string_view> fcpProfiles();
bool isFcpProfile(std::string_view name);

} // namespace simulation
