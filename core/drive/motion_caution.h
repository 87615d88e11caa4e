// Which acts of motion the user is asked about first, and why: pure judgement, no state and no words. A stop is never
// in question, nor are the end of a ramp and the acknowledging of faults.
#pragma once

#include "drive/event.h"
#include "drive/motion_limits.h"
#include "drive/wish.h"

#include <optional>
#include <vector>

namespace drive {

enum class MotionCaution : std::uint8_t {
    FirstStart, ///< the first START of this motor since the board was met
    Step, ///< a set-point that moves by more than a fifth of its limit
    StepFromUnknown, ///< one that moves by an unknown amount
    Reversal, ///< the other way, or torque against the turning, while the rotor turns
    Position, ///< the shaft goes to an angle, wherever it is now
    NoSpeedLimit, ///< torque control, in which nothing keeps the speed within the user's own limit
    OtherMode, ///< speed control becomes torque control or back, while the motor is driven
    UnknownMode, ///< whether it does is unknown
    EndsExperiment, ///< a motor that is moved by itself is taken over
};

/// How things stand with one motor. What is not known counts as the worse.
struct MotionScene {
    MotorState state = MotorState::Unknown;
    bool startedBefore = false;
    MotionBounds bounds;
    double ownSpeedLimitRpm = 0.0; ///< the user's; 0: none
    /// Steps between set-points up to these were agreed to until it is disarmed; 0: none.
    double agreedRpm = 0.0, agreedAmps = 0.0;
    std::optional<double> speedRpm; ///< measured
    std::optional<double> speedReferenceRpm, iqReferenceAmps, idReferenceAmps;
    std::optional<bool> torqueMode; ///< false: it controls the speed
    bool experiment = false; ///< one is running, which ends with any act
};

constexpr double kGreatestQuietStep = 0.2; ///< of the limit
constexpr double kTurningRpm = 10.0; ///< below that a rotor counts as standing

std::vector<MotionCaution> cautionsOf(const WishContent &act, const MotionScene &scene);

} // namespace drive
