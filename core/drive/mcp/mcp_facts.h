// What is known of the MCP board at the other end, shared by the parts of McpDrive. Plain data; filled by the
// identification, read by everybody else.
#pragma once

#include "drive/board_facts.h"

#include <map>

namespace drive {

struct McpFacts : BoardFacts {
    bool hso = false; ///< register family: HSO/ZeST instead of the standard one
    std::uint32_t version = 0; ///< 0xMMmmpp
    std::optional<std::chrono::milliseconds> watchdog; ///< what its name promises

    std::map<RegisterId, std::size_t> structureSizes; ///< as read twice when it was met

    std::uint32_t baud = 1843200;
    std::uint8_t linkId = 0; ///< decides which datalog register is ours
    std::size_t requestBytes = 32, responseBytes = 32,
                streamBytes = 0; ///< negotiated payload sizes
};

} // namespace drive
