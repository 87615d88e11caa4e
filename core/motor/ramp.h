// What a ramp of the speed set-point will do before it is sent: firmware that counts speeds in steps (ST's in 0.1 Hz)
// climbs in stairs of one, and ends on one. Pure functions; a step of 0 is a set-point as fine as it is given.
// Source: firmware's conversion of SPEED_RAMP and SPEED_REF (a division that cuts towards zero).
#pragma once

#include <cstddef>
#include <vector>

namespace motor {

constexpr double kSpeedStep_rpm = 6.0; ///< 0.1 Hz, mechanical
/// Firmware from 6.0 on takes speeds as 16 bits of rpm, older firmware as 16 bits of steps: beyond, they turn over into
/// the other direction.
constexpr double kMostSpeedSteps = 32767.0, kMostSpeed_rpm = 32767.0,
                 kMostInSteps_rpm = kSpeedStep_rpm * kMostSpeedSteps;

/// The speed that the firmware makes of it: 3001 -> 3000, -3005 -> -3000. Beyond 16 bits of steps: clipped.
double quantisedSpeed_rpm(double rpm, double step_rpm = kSpeedStep_rpm);

struct RampPoint {
    double time_s = 0.0;
    double speed_rpm = 0.0;
    bool operator==(const RampPoint &) const = default;
};

/// The set-point over time as a staircase: each point holds until the next one. The first is the present set-point at
/// 0, the last the quantised target at `duration_s`. No time: two points at 0.
/// @param step_rpm  of a stair, above 0
/// @param mostPoints  at least 2; longer staircases are thinned out evenly
std::vector<RampPoint> rampPreview(double from_rpm, double to_rpm, double duration_s,
    double step_rpm, std::size_t mostPoints = 2000);

/// How much of the way to an angle is made after a share of the time, 0 to 1: without jerk at either end. The
/// firmware's own path is made of pieces; it is as long, and no faster.
double positionShare(double timeShare);

/// The greatest speed on that way [rpm]; infinite without a time.
double positionPeakSpeed_rpm(double way_rad, double duration_s);

/// Acceleration [rpm/s]; infinite for a ramp without time, 0 if nothing changes.
double rampAcceleration_rpmps(double from_rpm, double to_rpm, double duration_s, double step_rpm);

} // namespace motor
