// Averaged switching, and the diodes by projected Gauss-Seidel on their three voltages.
#include "simulation/plant/legs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace simulation {

namespace {

constexpr int kMostSweeps = 60;
constexpr double kCloseEnough = 1e-8; ///< of the bus voltage

double duty(double value) { return std::isnan(value) ? 0.5 : std::clamp(value, 0.0, 1.0); }

} // namespace

Legs::Legs(const InverterParameters &inverter, double leastInductance_h)
    : m_inverter(inverter)
    , m_leastInductance_h(leastInductance_h)
{
}

void Legs::set(const Bridge &bridge)
{
    m_bridge = {bridge.on, duty(bridge.a), duty(bridge.b), duty(bridge.c)};
}

void Legs::prepare(double period_s, double bus_v)
{
    m_share = std::min(m_inverter.deadTime_s / period_s, 0.5);
    m_drop_v = 2.0 * m_share * m_inverter.diodeDrop_v;
    m_perZero = 16.0 * m_leastInductance_h / (std::max(bus_v, 1.0) * period_s);
}

Phases Legs::voltages(Phases current, double bus_v)
{
    const auto leg = [&](double i, double asked, double &sign, double &seen) {
        sign = std::clamp(i * m_perZero, -1.0, 1.0);
        seen = std::clamp(asked - m_share * sign, 0.0, 1.0);
        return seen * bus_v - m_drop_v * sign;
    };
    return {leg(current.a, m_bridge.a, m_sign.a, m_seen.a),
        leg(current.b, m_bridge.b, m_sign.b, m_seen.b),
        leg(current.c, m_bridge.c, m_sign.c, m_seen.c)};
}

Legs::Flow Legs::flow(Phases mean) const
{
    return {m_seen.a * mean.a + m_seen.b * mean.b + m_seen.c * mean.c,
        m_drop_v * (m_sign.a * mean.a + m_sign.b * mean.b + m_sign.c * mean.c)};
}

Legs::Freewheel Legs::freewheel(const Windings::Implied &windings, Rotation frame, double bus_v)
{
    const double low = -m_inverter.diodeDrop_v, high = bus_v + m_inverter.diodeDrop_v;
    struct Leg {
        double d, q; ///< the phase's axis in rotor coordinates
        double d_s, q_s; ///< what its voltage adds to the currents
        double perOwn_ohm, v;
    };
    const auto make = [&](Stationary axis, double v) {
        const Dq e = axis.in(frame);
        const double d_s = 2.0 / 3.0 * windings.admittance_s.d * e.d;
        const double q_s = 2.0 / 3.0 * windings.admittance_s.q * e.q;
        return Leg{e.d, e.q, d_s, q_s, 1.0 / (d_s * e.d + q_s * e.q), std::clamp(v, low, high)};
    };
    constexpr double kSide = Phases::kHalfRoot3;
    std::array<Leg, 3> legs{make({1.0, 0.0}, m_open_v.a), make({-0.5, kSide}, m_open_v.b),
        make({-0.5, -kSide}, m_open_v.c)};
    Dq i = windings.free_a;
    for (const Leg &leg : legs)
        i = {i.d + leg.d_s * leg.v, i.q + leg.q_s * leg.v};
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        double moved = 0.0;
        for (Leg &leg : legs) {
            const double own_a = leg.d * i.d + leg.q * i.q;
            const double to = std::clamp(leg.v - own_a * leg.perOwn_ohm, low, high);
            const double by = to - leg.v;
            leg.v = to;
            i = {i.d + leg.d_s * by, i.q + leg.q_s * by};
            moved = std::max(moved, std::abs(by));
        }
        if (moved <= kCloseEnough * high)
            break;
    }
    m_open_v = {legs[0].v, legs[1].v, legs[2].v};

    Freewheel result{.current = i, .flow = {}};
    bool floating = true;
    for (const Leg &leg : legs) {
        floating = floating && leg.v > low && leg.v < high;
        const double own_a = leg.d * i.d + leg.q * i.q;
        if (leg.v >= high)
            result.flow.bus_a += own_a;
        if (leg.v >= high || leg.v <= low)
            result.flow.lost_w += m_inverter.diodeDrop_v * std::abs(own_a);
    }
    return floating ? Freewheel{} : result;
}

bool Legs::blocks(double emf_v, double bus_v) const
{
    return 2.0 * Phases::kHalfRoot3 * emf_v < bus_v + 2.0 * m_inverter.diodeDrop_v;
}

} // namespace simulation
