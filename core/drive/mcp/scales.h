// What the board's configuration structures mean for the user: factors of digits, limits of set-points, what can be
// streamed, what can be done at all. Pure functions; nothing implausible becomes a number.
#pragma once

#include "drive/mcp/requests.h"
#include "mcp/structures.h"

#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace drive {

/// What one motor's structures said; empty where the build does not have one.
struct McpMotorDescription {
    std::optional<mcp::MotorConfig> motor;
    std::optional<mcp::ApplicationConfig> application;
    std::optional<mcp::FirmwareConfig> firmware;
    std::optional<mcp::ScaleConfig> scale;
};

/// Of speed, as FOCFW_CONFIG numbers it: how the names of its registers begin, and that of its speed.
struct McpSensor {
    std::uint8_t number;
    std::string_view prefix, speed;
};
inline constexpr std::uint8_t kPll = 1, kCordic = 2, kEncoder = 3, kHall = 4;
inline constexpr McpSensor kSensors[] = {{kPll, "STOPLL_", "STOPLL_ROT_SPEED"},
    {kCordic, "STOCORDIC_", "STOCORDIC_ROT_SPEED"}, {kEncoder, "ENCODER_", "ENCODER_SPEED"},
    {kHall, "HALL_", "HALL_SPEED"}};

/// From SCALE_CONFIG, or (firmware 6.0 and 6.1) from APPLICATION_CONFIG. Six-step: all unknown, its scales mean
/// something else. @param version 0xMMmmpp
catalog::Scales scalesOf(const McpMotorDescription &motor, std::uint32_t version);

/// Main and auxiliary one of a FOC build; empty: not known.
std::set<std::uint8_t> sensorsOf(const McpMotorDescription &motor);

/// Zero for what is missing, not finite, not positive or beyond a hard ceiling.
MotorLimits limitsOf(const McpMotorDescription &motor);

/// The tick counter advances for the control periods of every motor.
StreamLimits streamLimitsOf(const std::vector<McpMotorDescription> &motors, unsigned streams,
    std::size_t maxPacket, std::uint32_t baud);

void addCapabilities(McpFacts &board, const McpMotorDescription &first);

/// For unknown firmware: nothing is writable, numbers stay digits.
void makeRaw(std::vector<catalog::RegisterInfo> &registers);

} // namespace drive
