// The clamps of motion: no speed or current beyond what the board says it stands, or beyond what a person allows, is
// ever sent, and nothing is started whose limits are not known (drive/motion_limits.h). They live here, below every
// window and script. Nothing is clipped silently: a set-point beyond the limit is refused with the reason.
#pragma once

#include "drive/board_facts.h"
#include "drive/wish.h"

#include <chrono>
#include <string>

namespace drive {

/// Firmware takes speeds as 16 bits of rpm: beyond, they turn over into the other direction.
constexpr double kGreatestWireRpm = 32767.0;
/// What every protocol can hold.
constexpr std::chrono::milliseconds kLongestRamp{65535};

/// Why there is nothing to be moved; empty if there is that motor.
std::string refuseMotor(const BoardFacts &board, int motor);
/// Why no ramp lasts so long; empty if one may.
std::string refuseRampTime(std::chrono::milliseconds time);

/// Why this motor must not be started: a limit that is not known, named; empty if it may.
std::string refuseStart(const BoardFacts &board, int motor);

/// Why this set-point must not be sent; empty if it may. A limit that is not known refuses too.
std::string refuseSpeed(const BoardFacts &board, int motor, double rpm);
std::string refuseCurrent(const BoardFacts &board, int motor, double amps);

/// The same for a number written to a register that is a set-point; empty for all others.
std::string refuseNumber(const BoardFacts &board, const RegisterWrite &write);

} // namespace drive
