// What a START of a motor goes to, by what its board holds: the reference that its control follows, under whatever name
// the board has it. Pure functions; reading the registers is left to the caller.
//
// A speed or a current that is asked for while a motor rests is kept until it runs: the reference in force still has
// the old one then, or 0, and the last ramp has what a start goes to (firmware 6.0 to 6.4.2). Where a board tells its
// last ramp, that counts.
#pragma once

#include "catalog/catalog.h"
#include "drive/board_facts.h"
#include "drive/motor_view.h"

#include <chrono>
#include <optional>
#include <vector>

namespace drive {

struct StartTarget {
    /// Other: also where it is not known.
    catalog::ControlMode control = catalog::ControlMode::Other;
    std::optional<double> rpm; ///< of Speed, signed
    std::optional<double> amps; ///< of Torque: Iq, signed
    /// In which a start goes there, where a board tells it.
    std::optional<std::chrono::milliseconds> ramp = {};
};

/// The registers that startTarget() looks at; empty for a board without them.
std::vector<catalog::RegisterId> startRegisters(const catalog::Catalog &catalog, int motor);

/// @param held  what a register holds, as it was read
StartTarget startTarget(
    const catalog::Catalog &catalog, const MotorLimits &limits, int motor, const ValueSource &held);

/// Why a START must not be, by what the board was set to before it; empty if it may.
/// @param found  what was read for this judgement; what was not read refuses nothing
std::string refuseStartTarget(
    const BoardFacts &board, int motor, const std::vector<Reading> &found);

} // namespace drive
