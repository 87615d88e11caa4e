// What is known of the board at a line from when it was heard last. A stop needs it where nothing is heard any more; it
// outlives the link, the drive and the port. Plain data.
#pragma once

#include "aspep/packet.h"
#include "drive/protocol.h"

#include <optional>

namespace drive {

struct LineMemory {
    std::optional<Protocol> spoken{}; ///< where the drive had to find out
    int motors = 1;
    std::optional<aspep::Beacon> agreed{}; ///< of MCP over ASPEP; a board takes no wider one
};

} // namespace drive
