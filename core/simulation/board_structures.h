// What the simulated board says it is: names and raw configuration structures. The names say that it is simulated.
// Source: mcp-aspep facts 8 and 9; sizes as in the recorded sessions.
#pragma once

#include "base/bytes.h"
#include "simulation/firmware/firmware.h"
#include "simulation/profile.h"

#include <string_view>

namespace simulation {

struct BoardOptions;

constexpr std::string_view kControlStageName = "Simulated-G4";
constexpr std::string_view kPowerStageName = "Simulated24V";
constexpr std::string_view kMotorName = "Sim PMSM 24V";

// Each without the size that goes in front of it on the wire.
/// FW_NAME. A watchdog shows at its end.
std::string firmwareName(const Traits &traits, const BoardOptions &options);
Bytes globalConfig(const Traits &traits, const BoardOptions &options);
Bytes motorConfig(const Firmware &firmware);
Bytes applicationConfig(
    const Traits &traits, const Firmware &firmware); ///< 16 bytes; 14 as printed
Bytes focFirmwareConfig(const Traits &traits, const Firmware &firmware);
Bytes scaleConfig(const Traits &traits, const Firmware &firmware);

/// Rpm of one digit of the speeds that 6.2 gives as fractions of the full scale.
double fullScaleSpeedDigit_rpm(const Firmware &firmware);

} // namespace simulation
