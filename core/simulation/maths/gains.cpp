// Doubles here, once at design time; what runs in the loops are the integers that come out.
#include "simulation/maths/gains.h"

#include <cmath>
#include <numbers>

namespace simulation {

namespace {

constexpr int kCurrentKpShift = 10, kCurrentKiShift = 14;
constexpr int kSpeedKpShift = 9, kSpeedKiShift = 14;
constexpr int kPllKpShift = 14, kPllKiShift = 15;

std::int16_t cut(double value)
{
    return static_cast<std::int16_t>(std::clamp(std::trunc(value), -32767.0, 32767.0));
}

/// The largest exponent up to `most` with which value * 2^exponent fits 16 bits.
int shiftFor(double value, int most)
{
    int shift = std::clamp(most, 0, kMaxShift);
    while (shift > 0 && std::ldexp(value, shift) > kDigitsMax)
        --shift;
    return shift;
}

Pi::Gains gainsOf(double kp, int kpShift, double ki, int kiShift)
{
    const Fraction p = fractionOf(kp, kpShift), i = fractionOf(ki, kiShift);
    return {p.numerator, i.numerator, p.shift, i.shift};
}

} // namespace

Fraction fractionOf(double gain, int shift)
{
    int bits = std::clamp(shift, 0, kMaxShift);
    while (bits > 0 && std::abs(std::round(std::ldexp(gain, bits))) > kDigitsMax)
        --bits;
    const double numerator = std::clamp(std::round(std::ldexp(gain, bits)), -32767.0, 32767.0);
    return {static_cast<std::int16_t>(numerator), bits};
}

Pi::Gains currentGains(
    double ls_h, double rs_ohm, double bandwidth_radps, const CurrentSensing &sensing, double hfHz)
{
    const double perLoop = bandwidth_radps / sensing.loopGain();
    return gainsOf(ls_h * perLoop, kCurrentKpShift, rs_ohm * perLoop / hfHz, kCurrentKiShift);
}

Pi::Gains speedGains(const SpeedLoop &loop, const CurrentSensing &sensing)
{
    const double tau = loop.lag_s(), d = loop.damping;
    const double kp = loop.inertia_kgm2 / (loop.torqueConstant_nmPerA * d * tau); // A / (rad/s)
    const double ki = kp / (d * d * tau);
    const double digits = 2.0 * std::numbers::pi / 10.0 * sensing.digitsPerAmp();
    return gainsOf(kp * digits, kSpeedKpShift, ki * digits / loop.mfHz, kSpeedKiShift);
}

ObserverConstants observerGains(const ObserverDesign &design)
{
    const double perPeriod = 1.0 / (design.ls_h * design.hfHz);
    const double decay = design.rs_ohm * perPeriod; // of the current in one period
    const double z1 = (1.0 - decay) / 4.0, z2 = 0.25;
    const double gain1 = z1 + z2 - 2.0 + decay;
    const double gain2 =
        (1.0 - z1) * (1.0 - z2) / perPeriod * design.maxCurrent_a / design.maxBemf_v;
    const double bemf = design.maxBemf_v * perPeriod / design.maxCurrent_a;
    const double voltage = design.maxVoltage_v * perPeriod / design.maxCurrent_a;
    const int f1 = shiftFor(std::max({decay, -gain1, bemf, voltage}), design.f1Shift);
    const int f2 = shiftFor(gain2, design.f2Shift);
    return {.c1 = cut(std::ldexp(decay, f1)),
        .c3 = cut(std::ldexp(bemf, f1)),
        .c5 = cut(std::ldexp(voltage, f1)),
        .gain1 = cut(std::ldexp(gain1, f1)),
        .gain2 = cut(std::ldexp(gain2, f2)),
        .f1Shift = f1,
        .f2Shift = f2};
}

Pi::Gains pllGains(double wn_radps, double damping, double bemf_digits, double hfHz)
{
    const double wn = wn_radps / hfHz; // radians a period
    const double perDigit = 65536.0 / (2.0 * std::numbers::pi) / bemf_digits;
    return gainsOf(2.0 * damping * wn * perDigit, kPllKpShift, wn * wn * perDigit, kPllKiShift);
}

} // namespace simulation
