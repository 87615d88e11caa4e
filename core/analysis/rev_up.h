// The start-up of a sensorless drive: up to five stages of speed and current, as the register holds them, as a curve over
// time, and with what is usually wrong about them. Pure functions; nothing is sent.
//
// Each stage goes in a straight line from where the one before ended (the first from standstill without current) to its
// final speed and final Iq. A stage without time jumps there. The firmware runs through all five: those that are not
// wanted repeat the last one's values with 0 ms.
// Source: firmware's rev-up control and ST's PMSM FAQ, as collected in features 6.5.
#pragma once

#include "base/bytes.h"
#include "base/result.h"

#include <cstdint>
#include <vector>

namespace analysis {

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

struct RevUpPoint {
    double time_s = 0.0;
    double speed_rpm = 0.0;
    double current_a = 0.0;
    bool operator==(const RevUpPoint &) const = default;
};

/// Corner points of the curve, from (0, 0, 0) on; straight lines between them. A stage without time that changes
/// something is a second point at the same time. Stages without time at the end are left out.
std::vector<RevUpPoint> revUpCurve(const RevUp &stages, double ampsPerDigit);
/// The curve at a time; beyond its end its last values.
RevUpPoint revUpAt(const std::vector<RevUpPoint> &curve, double time_s);

double revUpDuration_s(const RevUp &stages);

/// What turns and what holds it back. 0: not known, or none.
struct MechanicalLoad {
    double kt_nmpa = 0.0; ///< torque per peak ampere
    double inertia_kgm2 = 0.0;
    double viscous_nms = 0.0;
    double coulomb_nm = 0.0;
};

/// Largest torque that a stage asks for: J alpha plus friction at its faster end [N m].
/// @param from_rpm  speed at its beginning. A stage without time and with another speed: infinite.
double neededTorque_nm(const RevUpStage &stage, double from_rpm, const MechanicalLoad &load);

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
};

/// In the order of the stages; empty: nothing to be seen.
std::vector<RevUpFinding> checkRevUp(
    const RevUp &stages, double ampsPerDigit, const RevUpLimits &limits);

/// ST's first guess of the speed from which on the observer works: 15 % of the highest.
double minimumStartSpeed_rpm(double maxSpeed_rpm);

} // namespace analysis
