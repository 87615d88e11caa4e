// What a START of a motor goes to, by what its board holds: the reference that its control follows, under whatever name the
// board has it. Pure functions; reading the registers is left to the caller.
#pragma once

#include "catalog/catalog.h"
#include "drive/control_mode.h"
#include "drive/motion_limits.h"

#include <functional>
#include <optional>
#include <vector>

namespace drive {

struct StartTarget {
    ControlMode control = ControlMode::Other; ///< Other: also where it is not known
    std::optional<double> rpm; ///< of Speed, signed
    std::optional<double> amps; ///< of Torque: Iq, signed
};

/// The registers that startTarget() looks at; empty for a board without them.
std::vector<catalog::RegisterId> startRegisters(const catalog::Catalog &catalog, int motor);

/// @param shown  what a register holds, in the unit of catalog.readScale(); empty: not known
StartTarget startTarget(const catalog::Catalog &catalog, const MotorLimits &limits, int motor,
    const std::function<std::optional<double>(catalog::RegisterId)> &shown);

} // namespace drive
