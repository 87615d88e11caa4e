// What the board measures: shunts, amplifiers and converters, with their offset, noise, steps and limits.
//
//   current reading = 32768 + offset - amps * digits per amp + noise, rounded, in 0..65535
//   (a current into the motor lowers the reading, as with ST's shunts in the lower legs; sampled at the middle of the
//   zero vector, where the current is its mean over the period: ripple is not seen)
//   bus and heatsink: true value + noise, in steps of a 12-bit converter
#pragma once

#include "simulation/plant/parameters.h"

#include <cstdint>

namespace simulation {

/// Reproducible noise, the same everywhere: xorshift of 64 bits. Also used to draw where a rotor rests.
class Noise {
public:
    explicit Noise(std::uint64_t seed)
        : m_state(seed * 0x9E3779B97F4A7C15ULL + 1)
    {
    }
    std::uint64_t bits()
    {
        m_state ^= m_state << 13;
        m_state ^= m_state >> 7;
        m_state ^= m_state << 17;
        return m_state;
    }
    /// 0 to 1, of 32 bits.
    double share() { return static_cast<double>(bits() >> 32) * (1.0 / 4294967296.0); }

private:
    std::uint64_t m_state;
};

class Sensing {
public:
    Sensing(const InverterParameters &inverter, std::uint64_t seed);

    /// Converts once; the readings stay until the next call.
    void sample(double a_a, double b_a, double bus_v, double heatsink_c);

    std::uint16_t currentA() const { return m_a; }
    std::uint16_t currentB() const { return m_b; }
    double bus_v() const { return m_bus_v; }
    double heatsink_c() const { return m_heatsink_c; }
    Noise &noise() { return m_noise; }

private:
    std::uint16_t current(double amps, unsigned noise) const;

    double m_digitsPerAmp, m_zero, m_step, m_busStep_v, m_busRange_v;
    double m_currentNoise, m_busNoise_v, m_heatsinkNoise_c; ///< a digit of a 16-bit random number
    Noise m_noise;
    std::uint16_t m_a = 32768, m_b = 32768;
    double m_bus_v = 0.0, m_heatsink_c = 0.0;
};

} // namespace simulation
