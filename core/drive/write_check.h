// What may be written to a register from anywhere: window, command line, file, script. The rules that hold for every
// protocol are here; what its raw bytes and its own numbers mean, each protocol looks at behind them. A value that may
// not be written is refused with the reason and never clipped, cut or wrapped.
#pragma once

#include "drive/board_facts.h"
#include "drive/wish.h"

#include <string>

namespace drive {

/// Why this value must not be written; empty if it may.
std::string refuseWrite(const BoardFacts &board, const RegisterWrite &write, Reach reach);

/// Why a motor must not be started, nor a register make it follow a current: the user's own limit of speed, which
/// nothing keeps in torque control. A torque that is asked for as such is another matter: there the user is told.
std::string refuseTorqueControl(const BoardFacts &board);

} // namespace drive
