// What a motor's control follows, behind the number of the register CONTROL_MODE. Facts: firmware 6.0 to 6.4.2.
#pragma once

#include <cstdint>

namespace catalog {

enum class ControlMode : std::uint8_t { Speed, Torque, Other };

constexpr std::int64_t kSpeedModeNumber = 3, kTorqueModeNumber = 4, kPositionModeNumber = 7;
constexpr std::int64_t kPositionReachedNumber = 2; ///< of POSITION_CTRL_STATE

constexpr ControlMode controlModeOf(std::int64_t number)
{
    return number == kSpeedModeNumber ? ControlMode::Speed
        : number == kTorqueModeNumber ? ControlMode::Torque
                                      : ControlMode::Other;
}

} // namespace catalog
