// The currents of three phases, and what the dead time of a bridge takes of its voltages for them. Pure.
//
// Each phase loses some tenths of a volt against its own current. Where that current swings through zero within a PWM period, because it
// is smaller than bus T / (16 L), it loses as much less as it is smaller: there the dead time acts as a resistance.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lab {

class PhaseCurrents {
public:
    /// @param angle_rad  electrical, of the coordinates of q_a and d_a
    PhaseCurrents(double angle_rad, double q_a, double d_a)
        : m_cosine(std::cos(angle_rad))
        , m_sine(std::sin(angle_rad))
        , m_a(q_a * m_cosine + d_a * m_sine)
    {
        const double beta = std::numbers::sqrt3 * (d_a * m_cosine - q_a * m_sine);
        m_b = -(m_a + beta) / 2.0;
        m_c = -(m_a - beta) / 2.0;
    }

    /// Along q, for each volt that a phase loses whose current does not swing through zero.
    /// @param swing_a  the least such current
    double lossAlongQ(double swing_a) const
    {
        const auto share = [swing_a](double amps) { return std::clamp(amps / swing_a, -1.0, 1.0); };
        const double a = share(m_a), b = share(m_b), c = share(m_c);
        return (2.0 * a - b - c) / 3.0 * m_cosine - (c - b) / std::numbers::sqrt3 * m_sine;
    }

private:
    double m_cosine, m_sine;
    double m_a, m_b = 0.0, m_c = 0.0;
};

} // namespace lab
