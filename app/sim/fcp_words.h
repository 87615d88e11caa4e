// The words that a static board of the older serial protocol obeys besides those of every board.
#pragma once

#include "control_words.h"
#include "simulation/fcp/fcp_board.h"

namespace sim {

/// `state N`, `faults HEX` (first motor), `execute`, `rx-timeout`, `rx-overrun`; all else as obey().
Result<Obeyed, std::string> obeyFcp(std::string_view line, simulation::FcpBoard &board);

} // namespace sim
