// What the board's design fixes and its structures tell: how digits relate to amps and volts, what it allows; and the
// states of its motor. Values only. Source: mcp-aspep sections 7, 8 and 9.
#pragma once

#include <cstdint>

namespace simulation {

enum class MotorState : std::uint8_t {
    Idle = 0,
    Alignment = 2,
    Start = 4,
    Run = 6,
    Stop = 8,
    FaultNow = 10,
    FaultOver = 11,
    ChargeBootCap = 16,
    OffsetCalib = 17,
    SwitchOver = 19,
};

struct Stage {
    double maxReadable_a = 60.175056458; ///< 32768 digits
    double nominal_v = 24.0; ///< of the bus
    double nominal_a = 5.0; ///< peak
    int maxSpeed_rpm = 4000;
    double busFullScale_v = 60.0; ///< of the bus converter, 65536 digits

    double ampsPerDigit() const { return maxReadable_a / 32768.0; }
    double voltsPerDigit() const { return nominal_v / (1.7320508075688772 * 32767.0); }
};

} // namespace simulation
