// The numbers of HSO builds: fixed point, per unit of three bases, from the digits that the firmware has.
// Source: mcp-aspep fact 9 (Q30 x base of SCALE_CONFIG; Q16, Q20, Q24 for SI values).
#pragma once

#include "simulation/mcp/register_table.h"

namespace simulation {

constexpr double kQ16 = 65536.0, kQ20 = 1048576.0, kQ24 = 16777216.0, kQ30 = 1073741824.0;
constexpr std::uint32_t kSpeedRamp_hzps = 100; ///< FOC_SPEEDRAMP at power-on, electrical

struct PerUnitBases {
    double voltage_v, current_a, frequency_hz;
};

/// What 1.0 stands for; SCALE_CONFIG says the same.
PerUnitBases perUnitBases(const Firmware &firmware);

std::uint32_t q30(double perUnit); ///< clamped to what 32 bits hold, +-2
std::uint32_t q16(double value); ///< clamped
double fromQ16(std::uint32_t value);

std::uint32_t currentQ30(const Firmware &firmware, double digits);
std::uint32_t voltageQ30(const Firmware &firmware, double digits);

double electricalHz(const Firmware &firmware, double speed_dHz);
double angle_rad(const Firmware &firmware); ///< electrical, as the control sees it; -pi to pi
double polePairs(const Firmware &firmware);
double fluxVoltsPerHertz(const Firmware &firmware); ///< peak, a phase, electrical
/// The usual constant of a data sheet: rms between two terminals at 1000 rpm.
double voltsPerKrpm(const Firmware &firmware);
double torquePerAmp_nm(const Firmware &firmware);
const MotorParameters &motorOf(const Firmware &firmware);

/// How long the ramp set in FOC_SPEEDRAMP takes for a step of so many Hz.
std::uint16_t speedRampTime_ms(const RegisterContext &at, double step_hz);

} // namespace simulation
