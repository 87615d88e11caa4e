// What the simulated board says it is: names and raw configuration structures. The names say that it is simulated.
// Source: mcp-aspep facts 8 and 9; sizes as in the recorded sessions.
#pragma once

#include "base/bytes.h"
#include "simulation/mcp/register_table.h"

#include <string>
#include <string_view>

namespace simulation {

constexpr std::string_view kControlStageName = "Simulated-G4";

/// FW_NAME. A watchdog shows at its end.
std::string firmwareName(const RegisterContext &at);
std::string powerStageName(const RegisterContext &at);
std::string motorName(const RegisterContext &at);

// Each without the size that goes in front of it on the wire.
Bytes globalConfig(const RegisterContext &at);
Bytes motorConfig(const RegisterContext &at);
Bytes applicationConfig(const RegisterContext &at); ///< 16 bytes; 14 up to 6.1 and as printed
Bytes firmwareConfig(const RegisterContext &at); ///< FOCFW_CONFIG: 14 bytes; 13 for six-step
Bytes scaleConfig(const RegisterContext &at);

constexpr std::size_t kBemfSensingWords = 13;
Bytes bemfSensingConfig(const RegisterContext &at);
/// Under which key a word of BEMF_ADC_CONF is kept: no register has it.
constexpr std::uint16_t bemfSensingKey(std::size_t word)
{
    return static_cast<std::uint16_t>(mcp::reg::kBemfAdcConf.bits + 64U * (word + 1));
}

/// Rpm of one digit of the speeds that GET gives as fractions of the full scale up to 6.3.
double fullScaleSpeedDigit_rpm(const Firmware &firmware);

} // namespace simulation
