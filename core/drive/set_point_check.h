// The clamps of motion: no speed or current beyond what the board says it stands, or beyond what the user allows, is
// ever sent, and nothing is started whose limits are not known (drive/motion_limits.h). They live here, below every
// window and script. Nothing is clipped silently: a set-point beyond the limit is refused with the reason.
#pragma once

#include "drive/board_facts.h"
#include "drive/wish.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace drive {

/// What every protocol can hold.
constexpr std::chrono::milliseconds kLongestRamp{65535};

/// The end of the reason where only a limit is missing that the user may do without.
inline constexpr const char *kExpertMode = "expert mode";

/// Why there is nothing to be moved; empty if there is that motor.
std::string refuseMotor(const BoardFacts &board, int motor);
/// Why no ramp lasts so long; empty if one may.
std::string refuseRampTime(std::chrono::milliseconds time);

/// Why this motor must not be started: a limit that is not known, named; empty if it may.
std::string refuseStart(const BoardFacts &board, int motor);
/// Why a command is not for this motor: there is none, or it must not be started.
std::string refuseCommand(const BoardFacts &board, const Command &command);

/// Why this set-point must not be sent; empty if it may. A limit that is not known refuses too.
std::string refuseSpeed(const BoardFacts &board, int motor, double rpm);
std::string refuseCurrent(const BoardFacts &board, int motor, double amps);

/// Why this speed must not be asked for by a protocol that holds so much; empty if it may.
std::string refuseWireSpeed(const BoardFacts &board, int motor, double rpm);

/// The least current, without its sign, that becomes so many whole digits. A limit has no digits of its own: the ones
/// that a set-point of just the limit becomes are within it.
double leastAmps(double digits, double ampsPerDigit);

/// Why so many digits of a current are none of a set-point; empty if they are.
std::string refuseDigits(double digits);

/// Why stages of a start-up are beyond what the user allows or the protocol can hold; empty if they are not.
std::string refuseStages(const BoardFacts &board, int motor, ByteView raw);

/// Whether stages read back as they were written, but for the speeds, which firmware keeps in steps of 0.1 Hz.
bool sameStages(const catalog::Value &written, const catalog::Value &read);

/// From where a board was switched on: a float resolves a thousandth of a radian there.
inline constexpr double kFarthest_rad = 1e4;

/// Where a position ramp goes.
struct Move {
    double radians = 0.0, seconds = 0.0;
};
/// Why the shaft must not go there, wherever it is now; empty if it may.
std::string refusePosition(const BoardFacts &board, int motor, const Move &wanted);
/// The same from where it is, because of the speed on the way. @param position_rad  not finite: it is not told
std::string refuseWay(const BoardFacts &board, int motor, const Move &wanted, double position_rad);

/// A speed ramp, torque ramp or current reference, as protocols have it that hold whole rpm and currents in 16 bits.
struct SetPoint {
    Feature feature = Feature::SpeedRamp;
    int motor = 1;
    double first = 0.0, second = 0.0; ///< rpm, A, or A of Iq and A of Id
    std::chrono::milliseconds duration{};
};
std::optional<SetPoint> setPointOf(const WishContent &act); ///< nothing: it is none of these
std::string refuseSetPoint(const BoardFacts &board, const SetPoint &wanted);
/// A current of a set-point that was not refused.
std::int16_t digitsOf(const BoardFacts &board, int motor, double amps);

/// The same for a number written to a register that is a set-point; empty for all others.
std::string refuseNumber(const BoardFacts &board, const RegisterWrite &write);

} // namespace drive
