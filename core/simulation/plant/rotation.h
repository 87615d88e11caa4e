// Angles as cosine and sine, and the rotor's two axes. Values only.
#pragma once

#include <cmath>

namespace simulation {

struct Rotation {
    double cosine = 1.0, sine = 0.0;

    static Rotation of(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }
    /// As `of`, to 1e-12 for the angles that a sub-step turns (below 0.1 rad).
    static Rotation small(double angle_rad)
    {
        if (!(std::abs(angle_rad) < 0.1))
            return of(angle_rad);
        const double x2 = angle_rad * angle_rad;
        return {1.0 - x2 * (0.5 - x2 * (1.0 / 24.0 - x2 * (1.0 / 720.0))),
            angle_rad * (1.0 - x2 * (1.0 / 6.0 - x2 * (1.0 / 120.0 - x2 * (1.0 / 5040.0))))};
    }
    Rotation then(Rotation more) const
    {
        return {cosine * more.cosine - sine * more.sine, sine * more.cosine + cosine * more.sine};
    }
};

/// A vector in rotor coordinates.
struct Dq {
    double d = 0.0, q = 0.0;

    /// The same vector seen from a rotor that has turned on.
    Dq seenAfter(Rotation turn) const
    {
        return {d * turn.cosine + q * turn.sine, q * turn.cosine - d * turn.sine};
    }
};

/// A vector in stationary coordinates, beta leading alpha by 90 degrees in the sense of positive speed. (ST's beta
/// has the other sign.)
struct Stationary {
    double alpha = 0.0, beta = 0.0;

    static Stationary from(Dq v, Rotation frame)
    {
        return {v.q * frame.cosine + v.d * frame.sine, v.q * frame.sine - v.d * frame.cosine};
    }
    Dq in(Rotation frame) const
    {
        return {alpha * frame.sine - beta * frame.cosine, alpha * frame.cosine + beta * frame.sine};
    }
};

struct Phases {
    double a = 0.0, b = 0.0, c = 0.0;

    static constexpr double kHalfRoot3 = 0.86602540378443864676;

    static Phases from(Stationary v)
    {
        const double half = -0.5 * v.alpha, side = kHalfRoot3 * v.beta;
        return {v.alpha, half + side, half - side};
    }
    /// What is common to all three does not reach a star without neutral.
    Stationary stationary() const
    {
        constexpr double kThird = 1.0 / 3.0, kPerRoot3 = 0.5 / kHalfRoot3;
        return {(2.0 * a - b - c) * kThird, (b - c) * kPerRoot3};
    }
};

} // namespace simulation
