// Volts and amps into digits.
#include "simulation/plant/sensing.h"

#include <algorithm>
#include <cmath>

namespace simulation {

namespace {

constexpr double kHalf16 = 32767.5; ///< centre of a 16-bit random number
constexpr double kHeatsinkStep_c = 0.0625;

double spread(unsigned bits16, double scale) { return (bits16 - kHalf16) * scale; }

double rounded(double value, double step) { return std::floor(value / step + 0.5) * step; }

} // namespace

Sensing::Sensing(const InverterParameters &inverter, std::uint64_t seed)
    : m_digitsPerAmp(inverter.digitsPerAmp())
    , m_zero(32768.0 + inverter.offset_digits)
    , m_step(std::ldexp(1.0, 16 - inverter.converterBits))
    , m_busStep_v(inverter.busRange_v / 4096.0)
    , m_busRange_v(inverter.busRange_v)
    , m_currentNoise(inverter.noise_digits / kHalf16)
    , m_busNoise_v(inverter.busNoise_v / kHalf16)
    , m_heatsinkNoise_c(inverter.heatsinkNoise_c / kHalf16)
    , m_noise(seed)
{
}

std::uint16_t Sensing::current(double amps, unsigned noise) const
{
    const double level = m_zero - amps * m_digitsPerAmp + spread(noise, m_currentNoise);
    if (std::isnan(level))
        return 32768;
    return static_cast<std::uint16_t>(std::clamp(rounded(level, m_step), 0.0, 65536.0 - m_step));
}

void Sensing::sample(double a_a, double b_a, double bus_v, double heatsink_c)
{
    const std::uint64_t random = m_noise.bits();
    const auto part = [random](int index) {
        return static_cast<unsigned>(random >> (16 * index) & 0xFFFF);
    };
    m_a = current(a_a, part(0));
    m_b = current(b_a, part(1));
    const double volts = std::clamp(bus_v + spread(part(2), m_busNoise_v), 0.0, m_busRange_v);
    m_bus_v = rounded(volts, m_busStep_v);
    m_heatsink_c = rounded(heatsink_c + spread(part(3), m_heatsinkNoise_c), kHeatsinkStep_c);
}

} // namespace simulation
