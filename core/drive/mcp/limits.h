// What may be written to this protocol's registers beyond the rules of all protocols: the raw registers that hold
// set-points.
#pragma once

#include "drive/mcp/requests.h"
#include "drive/set_point_check.h"
#include "drive/wish.h"

#include <optional>
#include <string>

namespace drive {

/// Why this must not be written, as far as it can be told without a look at the board; empty if it may: the rules of
/// all protocols (drive/write_check.h), and the bytes of raw registers.
std::string refuseWriteOf(const McpFacts &board, const RegisterWrite &write, Reach reach);

constexpr const char *kPosition = "CURRENT_POSITION"; ///< the register of where a shaft is

/// Of POSITION_RAMP; empty if it has another length.
std::optional<Move> positionIn(const Bytes &bytes);

} // namespace drive
