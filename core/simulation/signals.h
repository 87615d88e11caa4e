// What the simulated firmware keeps in its variables, all that registers of the standard family can show: measured
// signals in the digits of the registers, and settings that can be written. Plain values; the register file and the
// datalog read and write them where they are, the firmware looks at the settings in every period.
// Source: the columns format, unit and available_when of the register list of firmware 6.0 to 6.4.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace simulation {

/// The states of a motor. Source: mcp-aspep sections 7, 8 and 9.
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

/// Written by the firmware, read by others. 16-bit variables: currents (s16A) and voltages (s16V) in digits, angles in
/// 1/65536 electrical turn, speeds in 0.1 Hz mechanical.
struct Signals {
    std::int16_t iA = 0, iB = 0, iAlpha = 0, iBeta = 0, iQ = 0, iD = 0, iQRef = 0, iDRef = 0;
    std::int16_t vQ = 0, vD = 0, vAlpha = 0, vBeta = 0;

    // State observer with PLL, and the one with CORDIC: what they estimate. The back-EMF levels are squares, 1/2^15.
    std::int16_t pllAngle = 0, pllSpeed = 0, pllBemfAlpha = 0, pllBemfBeta = 0;
    std::int16_t pllIAlpha = 0, pllIBeta = 0;
    std::int16_t cordicAngle = 0, cordicSpeed = 0, cordicBemfAlpha = 0, cordicBemfBeta = 0;
    std::int16_t cordicIAlpha = 0, cordicIBeta = 0;
    std::int32_t pllEstimatedBemf = 0, pllObservedBemf = 0;
    std::int32_t cordicEstimatedBemf = 0, cordicObservedBemf = 0;

    std::int16_t encoderAngle = 0, encoderSpeed = 0;
    std::int16_t hallAngle = 0, hallSpeed = 0;
    std::int16_t openLoopAngle = 0; ///< of the virtual sensor that leads the rev-up

    std::int16_t ffVq = 0, ffVd = 0; ///< feed-forward voltages
    std::int16_t ffVqPi = 0, ffVdPi = 0; ///< averaged outputs of the regulators without them
    std::int16_t fluxWeakeningBus = 0; ///< FLUXWK_BUS_MEAS, 0.1 % of full modulation

    std::int16_t busVoltage_v = 0, temperature_c = 0;
    float power_w = 0.0F; ///< MOTOR_POWER, averaged
    float position_rad = 0.0F; ///< CURRENT_POSITION, mechanical
    float cpuLoad = 0.0F, cpuLoadMin = 0.0F, cpuLoadMax = 0.0F; ///< percent
    std::uint8_t positionState = 0, alignState = 0; ///< POSITION_CTRL_STATE, POSITION_ALIGN_STATE
};

/// Written from outside, read by the firmware. Gains are numerators; the *Div members are exponents of two.
struct Tuning {
    std::int16_t speedKp = 4032, speedKi = 7700, speedKd = 0, speedKpDiv = 7, speedKiDiv = 14,
                 speedKdDiv = 4;
    std::int16_t qKp = 0, qKi = 0, qKd = 0, qKpDiv = 10, qKiDiv = 14, qKdDiv = 5;
    std::int16_t dKp = 0, dKi = 0, dKd = 0, dKpDiv = 10, dKiDiv = 14, dKdDiv = 5;
    std::int16_t pllC1 = -24379, pllC2 = 18041; ///< STOPLL_C1, STOPLL_C2: of its state observer
    std::int16_t pllKp = 638, pllKi = 45, pllKpDiv = 14, pllKiDiv = 15;
    std::int16_t cordicC1 = -24379, cordicC2 = 18041;

    std::int16_t fluxKp = 3000, fluxKi = 5000, fluxKpDiv = 15, fluxKiDiv = 15;
    std::int16_t fluxBus = 950; ///< FLUXWK_BUS, 0.1 % of full modulation
    std::int32_t ff1Q = 0, ff1D = 0, ff2 = 0;

    std::int16_t positionKp = 0, positionKi = 0, positionKd = 0, positionKpDiv = 10,
                 positionKiDiv = 14, positionKdDiv = 5;

    std::int16_t openLoopVq = 5; ///< FOC_VQREF, percent of full modulation
    std::int16_t overVoltage_v = 28, underVoltage_v = 12; ///< thresholds of the bus
};

/// What the self-commissioning shows and is told (SC_*): it is stored, and does not run.
struct Commissioning {
    std::uint8_t state = 0, steps = 0, polePairs = 0, focRate = 1, completed = 0;
    std::int16_t pwm_hz = 0;
    float rs_ohm = 0.0F, ls_h = 0.0F, ke_vrmsPerKrpm = 0.0F, bus_v = 0.0F, speed_rpm = 0.0F;
    float current_a = 0.0F, speedBandwidth_radps = 0.0F, ldLqRatio = 1.0F,
          currentBandwidth_radps = 0.0F;
    float inertia_kgm2 = 0.0F, friction_nms = 0.0F, startUp_a = 0.0F, resistorOffset_ohm = 0.0F;
    std::int32_t nominalSpeed_rpm = 0, startUpSpeed_rpm = 0, startUpAcceleration_rpmps = 0;
};

/// What a numerator and an exponent of two stand for; exponents that no divisor has are cut to 0..31.
inline double scaledGain(std::int16_t numerator, std::int16_t exponent)
{
    return std::ldexp(numerator, -std::clamp<int>(exponent, 0, 31));
}

} // namespace simulation
