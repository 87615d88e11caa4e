// Digits to per unit.
#include "simulation/mcp/per_unit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace simulation {

namespace {

std::uint32_t fixedPoint(double value, double one)
{
    const double raw = std::clamp(value * one, -2147483648.0, 2147483647.0);
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(raw));
}

} // namespace

const MotorParameters &motorOf(const Firmware &firmware)
{
    return firmware.plant().parameters().motor;
}

double polePairs(const Firmware &firmware) { return motorOf(firmware).polePairs; }

PerUnitBases perUnitBases(const Firmware &firmware)
{
    // Room for braking above the nominal bus and for speeds above the greatest.
    const Stage &stage = firmware.stage();
    return {2.0 * stage.nominal_v, stage.maxReadable_a,
        1.5 * stage.maxSpeed_rpm / 60.0 * polePairs(firmware)};
}

std::uint32_t q30(double perUnit) { return fixedPoint(perUnit, kQ30); }
std::uint32_t q16(double value) { return fixedPoint(value, kQ16); }
double fromQ16(std::uint32_t value) { return static_cast<std::int32_t>(value) / kQ16; }

std::uint32_t currentQ30(const Firmware &firmware, double digits)
{
    return q30(digits * firmware.stage().ampsPerDigit() / perUnitBases(firmware).current_a);
}

std::uint32_t voltageQ30(const Firmware &firmware, double digits)
{
    return q30(digits * firmware.stage().voltsPerDigit() / perUnitBases(firmware).voltage_v);
}

double electricalHz(const Firmware &firmware, double speed_dHz)
{
    return speed_dHz / 10.0 * polePairs(firmware);
}

double angle_rad(const Firmware &firmware)
{
    return firmware.variables().pllAngle * (std::numbers::pi / 32768.0);
}

double fluxVoltsPerHertz(const Firmware &firmware)
{
    return motorOf(firmware).flux_wb * 2.0 * std::numbers::pi;
}

double voltsPerKrpm(const Firmware &firmware)
{
    constexpr double kHertzPerKrpm = 1000.0 / 60.0;
    const double peak_v = fluxVoltsPerHertz(firmware) * polePairs(firmware) * kHertzPerKrpm;
    return peak_v * std::sqrt(3.0 / 2.0);
}

double torquePerAmp_nm(const Firmware &firmware)
{
    return 1.5 * polePairs(firmware) * motorOf(firmware).flux_wb;
}

std::uint16_t speedRampTime_ms(const RegisterContext &at, double step_hz)
{
    constexpr mcp::RegisterId kSpeedRamp = mcp::registerId(53, mcp::RegisterType::Bits32, 0);
    const auto written = at.kept.find(kSpeedRamp.bits);
    const double rate_hzps = written == at.kept.end() ? kSpeedRamp_hzps : fromQ16(written->second);
    if (!(rate_hzps > 0.0))
        return 0;
    return static_cast<std::uint16_t>(std::min(step_hz / rate_hzps * 1000.0, 65535.0));
}

} // namespace simulation
