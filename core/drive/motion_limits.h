// What bounds the motion of a motor: what its board says it stands and what the user allows, the lower of the two. Pure
// functions, the same for every protocol; a drive enforces them, a window shows them.
//
// A limit that the board does not tell, or tells as nonsense (zero here), bounds nothing, so nothing may move by it:
// only in expert mode, which the user enters knowingly for one motor and which ends with the connection, do the user's
// own limit and the ceiling of this file take its place.
#pragma once

#include "catalog/catalog.h"
#include "drive/event.h"
#include "drive/wish.h"

#include <vector>

namespace drive {

// Beyond these a number is a misread structure, not a motor.
constexpr double kHighestRpm = 500000.0, kHighestAmps = 5000.0;

/// What a board tells of itself; 0 where it is not finite, not positive or beyond a ceiling.
double plausible(double value, double ceiling);

/// A limit that a board should tell and did not.
enum class LimitGap : std::uint8_t { MaxSpeed, MaxCurrent, NominalCurrent };
std::vector<LimitGap> gapsIn(const MotorLimits &limits);

/// What may be asked of a motor. Zero: nothing, because its limit is not known.
struct MotionBounds {
    double rpm = 0.0;
    double amps = 0.0;
    bool operator==(const MotionBounds &) const = default;
};
MotionBounds boundsOf(const MotorLimits &limits, const UserLimits &user, bool expert);

/// The same without the ceilings: what a board tells or the user allows. Zero: neither does, whatever the mode.
MotionBounds realBoundsOf(const MotorLimits &limits, const UserLimits &user);

/// Whether the user's limits are numbers that can bound something: finite and not negative.
bool isPlausible(const UserLimits &user);

/// Whether a full-scale current is one that an inverter can have: 0 (not known), or up to kHighestAmps.
bool isPlausible(const CurrentScale &scale);

/// What one raw digit of a set-point's register asks for: rpm of a speed, A of a current, and of a torque the A that
/// it takes. Zero: not known, or no set-point.
double setPointPerDigit(
    const catalog::RegisterInfo &info, const catalog::Scale &scale, const MotorLimits &limits);

} // namespace drive
