// Where the shaft of a motor is, by what its board holds: under whatever name and in whatever unit the board has it.
// Pure functions; reading the registers is left to the caller.
#pragma once

#include "catalog/catalog.h"
#include "drive/motor_view.h"

#include <optional>
#include <vector>

namespace drive {

/// The registers that shaftAngle_rad() looks at; empty for a board without them.
std::vector<RegisterId> shaftRegisters(const catalog::Catalog &catalog, int motor);

/// Mechanical, turns included, from the board's own zero [rad]; empty while it is not known, nor what its counts are.
/// @param held  what a register holds, as it was read
std::optional<double> shaftAngle_rad(
    const catalog::Catalog &catalog, int motor, const ValueSource &held);

} // namespace drive
