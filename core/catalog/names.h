// Names of numbers: states, modes, faults and configuration flags, in English. Those in capitals are the firmware's own
// words; a window may translate the others. And what kind of fault stands behind a name, so that a window can explain
// it whatever the protocol. Facts: firmware 6.0 to 6.4.2.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace catalog {

struct NamedValue {
    std::int64_t value = 0;
    std::string_view name;
};

/// Named values of an enumeration register (STATUS, CONTROL_MODE, ...) by its standard name, or of a field of the
/// configuration structures ("drive type", "flags 1", ...) by its key; empty if it has none.
std::span<const NamedValue> namedValues(std::string_view registerName);
/// The name of one value; the number itself where it has none.
std::string valueName(std::string_view registerName, std::int64_t value);

/// Names of the bits that are set in a flags register (FAULTS_FLAGS: one half, 16 bits;
/// START_CONFIGURATION, ...); a bit without a name is shown as "bit 11".
std::vector<std::string> faultNames(std::uint16_t bits);
std::vector<std::string> flagNames(std::string_view registerName, std::uint32_t bits);
/// Whether a flags register holds the present faults in its upper and the past ones in its lower half.
bool holdsPastFaults(std::string_view registerName);
/// Every bit of a flags register that has a name; `value` is the mask.
std::span<const NamedValue> namedFlags(std::string_view registerName);

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

} // namespace catalog
