// What kind of fault stands behind a firmware's name for it, so that a window can explain it whatever the protocol.
// Facts: firmware 6.0 to 6.4.2.
#pragma once

#include <cstdint>
#include <string_view>

namespace drive {

enum class FaultKind : std::uint8_t {
    Other,
    Duration, ///< the control loop did not finish in time
    OverVoltage,
    UnderVoltage,
    OverTemperature,
    StartUp, ///< a sensorless start failed
    SpeedFeedback, ///< the speed is not to be relied on
    OverCurrent, ///< the power stage's own switch-off, or the current measured
    Software,
    Sampling, ///< the currents could not be sampled
    DriverProtection, ///< the gate driver's protection pin
};

/// By the firmware's name, e.g. "OVER_VOLT"; Other for names that are not known here.
FaultKind faultKindOf(std::string_view name);

} // namespace drive
