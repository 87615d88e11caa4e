// The clamps of motion for writes of this protocol's registers: the set-points among them, and the raw ones that hold
// set-points.
#pragma once

#include "drive/mcp/mcp_board.h"
#include "drive/set_point_check.h"

#include <string>

namespace drive {

/// Why this register must not be written; empty for all that are no set-points.
std::string refuseSetPoint(const McpBoard &board, const RegisterWrite &write);

} // namespace drive
