// The Luenberger observer of the sensorless firmware: from currents and voltages it estimates currents and back-EMF,
// in integers. It knows no angle; ObserverPll and ObserverCordic find one in what it sees.
//
//   i+ = i - C1 i/F1 + C2 (i/F1 - measured) + C5 voltage - C3 e/F2          (scaled by F1)
//   e+ = e + C4 (i/F1 - measured) +- e/F2 * speed                           (scaled by F2)
// All as 32-bit integers; i/F1 and e/F2 are arithmetic shifts, cut to -32767..32767 before.
//
// `voltage` is the mean of the period around the measurement: half of what was set last time and half of what is set
// now, cut towards minus infinity. On a real board currents are sampled in the middle of a PWM period and new duties
// wait for its end, so what the firmware computed last is that mean. Here duties take effect at the sample; fed with
// them alone, the angle would be half a period ahead.
// Source: features 6.6; the turning of e by the averaged speed as ST's library does it.
#pragma once

#include "simulation/maths/fixed_point.h"

namespace simulation {

constexpr int kMaxShift = 15; ///< of 16 bits

struct ObserverConstants {
    /// Resistance, back-EMF, voltage: of the motor and the scales.
    std::int16_t c1 = 0, c3 = 0, c5 = 0;
    std::int16_t gain1 = 0, gain2 = 0; ///< C2 (negative) and C4
    int f1Shift = 14, f2Shift = 13; ///< F1 and F2 as exponents of two, 0..15
};

/// What one step takes: the currents just measured, the voltage set at the same moment, and the bus as the converter
/// reads it (65536: full scale).
struct ObserverInput {
    AlphaBeta voltage; ///< 32768: bus / sqrt(3), as modulate() takes it
    AlphaBeta current;
    std::uint16_t bus = 0;
};

class StateObserver {
public:
    explicit StateObserver(ObserverConstants constants);

    /// One control period; `speed_dpp` is the averaged electrical speed, 1/65536 turn a period.
    void step(const ObserverInput &input, std::int16_t speed_dpp);
    void clear();

    AlphaBeta current() const { return m_current; } ///< expected at the next step, s16A
    /// At this step; 32767: the largest that C3 was computed for.
    AlphaBeta bemf() const { return m_bemf; }
    const ObserverConstants &constants() const { return m_constants; }
    void setGains(std::int16_t gain1, std::int16_t gain2);

private:
    struct Axis {
        std::int32_t current = 0, bemf = 0; ///< times F1, times F2
    };
    void stepAxis(
        Axis &axis, std::int16_t measured, std::int16_t voltage, std::int64_t turned) const;
    std::int16_t unscaled(std::int32_t &value, int shift) const;

    ObserverConstants m_constants;
    int m_turnShift; ///< F3: keeps bemf * C6 * speed in 32 bits
    std::int32_t m_turnGain; ///< C6 = F2 F3 / (65536 / 2 pi)
    Axis m_alpha, m_beta;
    AlphaBeta m_current, m_bemf, m_voltage;
};

} // namespace simulation
