// A turning motor in slices of some samples, in the coordinates of the rotor as its board sees it: what the equations
// of its voltages are solved with. Pure.
#pragma once

#include "lab/evaluation/segments.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lab {

/// The currents of three phases, and what the dead time of a bridge takes of its voltages for them.
///
/// Each phase loses some tenths of a volt against its own current. Where that current swings through zero within a PWM
/// period, because it is smaller than bus T / (16 L), it loses as much less as it is smaller: there the dead time acts
/// as a resistance.
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

    /// Share of the phases whose current swings through zero.
    double swinging(double swing_a) const
    {
        const auto one = [swing_a](double amps) { return std::abs(amps) < swing_a ? 1.0 : 0.0; };
        return (one(m_a) + one(m_b) + one(m_c)) / 3.0;
    }

private:
    double m_cosine, m_sine;
    double m_a, m_b = 0.0, m_c = 0.0;
};

/// Means over a slice, and changes within it per second.
struct TurningSlice {
    double angle_rad = 0.0; ///< at its beginning, electrical, turns included
    double speed = 0.0; ///< rad/s electrical, of the coordinates
    double rotorSpeed = 0.0; ///< rad/s electrical, of the rotor; see rotorSpeeds()
    /// Of the coordinates from the rotor, as far as it changes with time and currents.
    double aside_rad = 0.0;
    double q_a = 0.0, d_a = 0.0;
    double earlyQ_a = 0.0, earlyD_a = 0.0; ///< the beginning counts twice, the end nothing
    double dq = 0.0; ///< A/s
    double q_v = 0.0;
};

/// Slices that follow one another without a gap.
struct TurningSlices {
    double step_s = 0.0;
    double period_s = 0.0; ///< of the board's control loops
    std::size_t length = 0; ///< of a slice, samples
    std::vector<TurningSlice> all;
    std::vector<PhaseCurrents> phases; ///< of each sample, the one behind the last slice included

    /// What the dead time takes along q in a slice, for each volt that a phase loses. @param swing_a  see PhaseCurrents
    double lossAlongQ(std::size_t slice, double swing_a) const;
};

/// @param segment  with Iq, Id and Vq as its values, in this order
/// @param slice_s  as long as that, or a sample less or more
TurningSlices slicesOf(const Segment &segment, double slice_s);

/// Fills in how fast the rotor itself turned. What a board observes of its rotor lags behind when the torque jumps, and
/// so do the coordinates; the rotor does what its inertia and its friction allow: within stretches of 50 ms its angle
/// is a Int(Int(iq)) + friction + b id, iq id, id^2, integrated twice + a straight line, and what it is seen to stand
/// aside with each current is kept apart from that. They are told by least squares over all stretches; where they
/// cannot be, the speed is that of the coordinates.
/// @return  how far coordinates that do not follow currents stand aside for good, electrical rad: what flows along d
///          makes torque then. Simulated encoders: within 0.2 degrees
double rotorSpeeds(std::vector<TurningSlices> &slices);

} // namespace lab
