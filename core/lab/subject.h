// The motor that is measured, and what its board offers for that: registers to record, to poll, to compare afterwards.
// Plain values, from the board's identification.
#pragma once

#include "base/result.h"
#include "drive/event.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace lab {

/// Registers of the motor. 0: the board has none.
struct Registers {
    drive::RegisterId reference = 0, referenceD = 0; ///< Iq and Id, wanted
    drive::RegisterId current = 0, currentD = 0; ///< Iq and Id, measured
    drive::RegisterId voltage = 0, voltageD = 0; ///< Vq and Vd, as they are asked for
    drive::RegisterId speed = 0, angle = 0; ///< of the main sensor
    drive::RegisterId bus = 0, temperature = 0; ///< polled
    drive::RegisterId gain = 0, gainExponent = 0; ///< of the speed loop's proportional part
    drive::RegisterId integral = 0, integralExponent = 0; ///< of its integral part
    /// The stages of a start without a sensor; written, not recorded.
    drive::RegisterId startUp = 0;
    drive::RegisterId position = 0; ///< of the shaft, rad; where the board controls it
    /// In force, rpm; read with the set-point, and recorded where samples come with each exchange.
    drive::RegisterId speedReference = 0;
};

/// What the angle's register is called tells its sensor.
inline bool byHall(std::string_view angle) { return angle.starts_with("HALL"); }
inline bool byEncoder(std::string_view angle) { return angle.starts_with("ENCODER"); }

struct Subject {
    int motor = 1;
    /// The board records nothing by itself: speed and Iq are read one after the other, and there are no other signals.
    bool polled = false;
    /// It does not record, either: its signals come with each exchange of the line, all of one instant, up to a
    /// thousand times a second.
    bool exchanged = false;
    Registers registers;
    std::shared_ptr<const catalog::Catalog> catalog;
    drive::MotorLimits limits; ///< of the motor
    std::vector<drive::RegisterId> setPoint; ///< drive::startRegisters()
    /// What says how a start goes to its speed, where each speed that is asked for writes that; the mode last.
    std::vector<drive::RegisterId> way = {};
    double tickHz = 0.0, linkBytesPerSecond = 0.0;

    /// As fast as its control loop works.
    bool records() const { return !polled && !exchanged; }

    std::string nameOf(drive::RegisterId id) const; ///< empty for 0
    /// One sample every so many control periods, so that this many signals leave room on the link for everything else.
    unsigned fastEvery(std::size_t signalCount) const;
    bool seesRotor() const; ///< by a sensor, also at rest
    /// Below it a motor without a sensor is not measured: twice the least speed at which its observer is believed. 0:
    /// it has a sensor, or nothing is known of its speeds.
    /// @param own_rpm  the user's limit: where values are polled it stands for one that the board does not tell
    double leastObservedRpm(double own_rpm = 0.0) const;
};

/// The motor of this number; or why nothing can be measured with this board, in a sentence.
Result<Subject, std::string> subjectOf(const drive::Identified &board, int motor);
/// The same for what fewer values tell as well, steps of the speed and the mechanics: a board that records nothing will
/// do, whose registers are read one after the other as often as the line gives, or come with each exchange; these tell
/// the response of a speed, too.
Result<Subject, std::string> pollableSubjectOf(const drive::Identified &board, int motor);

} // namespace lab
