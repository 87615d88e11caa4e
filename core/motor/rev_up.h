// The start-up of a sensorless drive: up to five stages of speed and current, as the register holds them, as a curve
// over time, and with what is usually wrong about them. Pure functions; nothing is sent.
//
// Each stage goes in a straight line from where the one before ended (the first from standstill without current) to its
// final speed and final Iq. A stage without time jumps there. The firmware runs through all five: those that are not
// wanted repeat the last one's values with 0 ms.
// Source: firmware's rev-up control and ST's PMSM FAQ, as collected in features 6.5.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "motor/ramp.h"

#include <cstdint>
#include <vector>

namespace motor {

constexpr std::size_t kRevUpStages = 5;

/// One stage in the register's own numbers: bytes and stages turn into each other without loss.
struct RevUpStage {
    std::int32_t speed_rpm = 0; ///< mechanical, at its end; firmware keeps 16 bits of it
    std::int16_t current_digits = 0; ///< Iq at its end; six-step: pulse
    std::uint16_t duration_ms = 0;
    bool operator==(const RevUpStage &) const = default;
};
using RevUp = std::vector<RevUpStage>; ///< at most kRevUpStages

enum class RevUpError : std::uint8_t { WrongSize };

/// 8 bytes a stage, at most 40; any other size is an error.
Result<RevUp, RevUpError> revUpOfBytes(ByteView bytes);
Bytes bytesOf(const RevUp &stages); ///< stages beyond the fifth are left out

/// All five: missing ones repeat the last with 0 ms, as ST's generator writes them. No stages: five of nothing.
RevUp completed(RevUp stages);
/// Without the stages at the end that take no time.
std::size_t usedStages(const RevUp &stages);

// Edits. Stages given are completed to five first; the result always has five.

/// Another stage in place of one; those after it that repeat the old one without time go on repeating it.
RevUp withStage(const RevUp &stages, std::size_t index, const RevUpStage &stage);
/// One more after `index`: it lasts as long and ends where that one ends, to be moved from there. Unchanged if all are
/// used.
RevUp withStageAfter(const RevUp &stages, std::size_t index);
/// The ones after it move up.
RevUp withoutStage(const RevUp &stages, std::size_t index);
/// Two used stages change places; unchanged if one of them is not used.
RevUp withSwapped(const RevUp &stages, std::size_t a, std::size_t b);

/// What a stage can be set to by hand: what the register holds and what the board's limits allow.
struct RevUpBounds {
    std::int32_t speed_rpm = 32766; ///< largest magnitude
    std::int16_t digits = 32767; ///< largest magnitude
    bool pulse = false; ///< six-step: no negative currents
    std::uint16_t duration_ms = 65535; ///< longest
    double speedStep_rpm = kSpeedStep_rpm; ///< what the drive keeps of a speed
};
/// @param maxSpeed_rpm, maxCurrent_a  0: not known, only the register bounds
RevUpBounds revUpBounds(double maxSpeed_rpm, double maxCurrent_a, double ampsPerDigit,
    double speedStep_rpm = kSpeedStep_rpm);

/// The nearest that the register holds, speeds in whole steps, within the bounds; what is not a number leaves `old`'s.
RevUpStage fittedStage(const RevUpStage &old, double speed_rpm, double digits, double duration_ms,
    const RevUpBounds &bounds);

/// What the firmware keeps of it: each speed cut to whole steps.
RevUp keptByFirmware(RevUp stages, double speedStep_rpm = kSpeedStep_rpm);

/// ST's start values: 2 s of half the nominal current at rest, then 3 s to 30 % of the highest speed.
RevUp usualRevUp(double nominalCurrent_a, double maxSpeed_rpm, double ampsPerDigit);

double revUpDuration_s(const RevUp &stages);

/// What turns and what holds it back. 0: not known, or none.
struct MechanicalLoad {
    double kt_nmpa = 0.0; ///< torque per peak ampere
    double inertia_kgm2 = 0.0;
    double viscous_nms = 0.0;
    double coulomb_nm = 0.0;
    bool operator==(const MechanicalLoad &) const = default;
};

/// Largest torque that a stage asks for: J alpha plus friction at its faster end [N m].
/// @param from_rpm  speed at its beginning. A stage without time and with another speed: infinite.
double neededTorque_nm(const RevUpStage &stage, double from_rpm, const MechanicalLoad &load);

/// The torque that a stage's current gives at its weaker end, the current being linear in time [N m].
double availableTorque_nm(
    const RevUp &stages, std::size_t index, double ampsPerDigit, const MechanicalLoad &load);

enum class RevUpMistake : std::uint8_t {
    // The four classic ones.
    TooLittleTorque, ///< the rotor cannot follow: less acceleration or more current [N m]
    EndsTooSlow, ///< the observer does not see the rotor at the final speed [rpm]
    TooMuchCurrent, ///< beyond the motor's nominal or the drive's largest current [A]
    StageWithoutTime, ///< before the last used one: speed or current jump [ms]
    // And what the firmware will not do.
    SpeedBeyondLimit, ///< [rpm]
    SpeedDoesNotFit, ///< beyond 16 bits, the firmware cuts it [rpm]
    TurnsBack, ///< a stage against the direction of the others [rpm]
    NoStage, ///< nothing takes any time: no start [ms]
};

struct RevUpFinding {
    RevUpMistake mistake = RevUpMistake::NoStage;
    std::size_t stage = 0; ///< 0 to 4
    double is = 0.0; ///< in the unit that the mistake names
    double limit = 0.0; ///< what it should stay within, or reach
    bool operator==(const RevUpFinding &) const = default;
};

/// What to judge by. 0: not known, nothing is said about it.
struct RevUpLimits {
    MechanicalLoad load; ///< Kt and inertia 0: no word about torque
    double minimumSpeed_rpm = 0.0; ///< from which on the observer works
    double nominalCurrent_a = 0.0;
    double maxCurrent_a = 0.0; ///< of the drive
    double maxSpeed_rpm = 0.0;
    bool operator==(const RevUpLimits &) const = default;
};

/// In the order of the stages; empty: nothing to be seen.
std::vector<RevUpFinding> checkRevUp(
    const RevUp &stages, double ampsPerDigit, const RevUpLimits &limits);

/// ST's first guess of the speed from which on the observer works: 15 % of the highest.
double minimumStartSpeed_rpm(double maxSpeed_rpm);

} // namespace motor
