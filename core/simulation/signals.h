// What the simulated firmware keeps in its variables: measured signals in the digits of the registers, gains that can
// be written. Plain values; the register file and the datalog read them where they are.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace simulation {

/// 16-bit variables: currents and voltages in digits, angles in 1/65536 turn, speeds in 0.1 Hz.
struct Signals {
    std::int16_t iA = 0, iB = 0, iAlpha = 0, iBeta = 0, iQ = 0, iD = 0, iQRef = 0, iDRef = 0;
    std::int16_t vQ = 0, vD = 0, vAlpha = 0, vBeta = 0;
    std::int16_t angle = 0, speed = 0, bemfAlpha = 0, bemfBeta = 0; ///< of the observer
    std::int16_t hallAngle = 0, hallSpeed = 0, openLoopAngle = 0;
    std::int16_t busVoltage_v = 0, temperature_c = 0;
};

/// Numerators; the *Div members are exponents of two.
struct Tuning {
    std::int16_t speedKp = 4032, speedKi = 7700, speedKd = 0, speedKpDiv = 7, speedKiDiv = 14,
                 speedKdDiv = 4;
    std::int16_t qKp = 0, qKi = 0, qKd = 0, qKpDiv = 10, qKiDiv = 14, qKdDiv = 5;
    std::int16_t dKp = 0, dKi = 0, dKd = 0, dKpDiv = 10, dKiDiv = 14, dKdDiv = 5;
    std::int16_t observerC1 = -24379, observerC2 = 18041;
    std::int16_t pllKp = 638, pllKi = 45, pllKpDiv = 14, pllKiDiv = 15;
};

/// What a numerator and an exponent of two stand for; exponents that no divisor has are cut to 0..31.
inline double scaledGain(std::int16_t numerator, std::int16_t exponent)
{
    return std::ldexp(numerator, -std::clamp<int>(exponent, 0, 31));
}

} // namespace simulation
