// What is known of a board of the older serial protocol, shared by the parts of LegacyDrive. Plain data; filled by the
// identification, read by everybody else.
#pragma once

#include "drive/board_facts.h"
#include "legacy/protocol.h"

namespace drive {

struct LegacyFacts : BoardFacts {
    legacy::Dialect dialect = legacy::Dialect::Stm32;
    double bytesPerSecond = 11520.0; ///< of the line, in each direction
};

} // namespace drive
