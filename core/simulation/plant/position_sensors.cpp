// Counts and codes of angles; edges are placed inside a step where the rotor crossed them.
#include "simulation/plant/position_sensors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace simulation {

namespace {

constexpr std::array<unsigned, 6> kForward{5, 1, 3, 2, 6, 4};

double wrapped(double value, double span)
{
    const double rest = value - span * std::floor(value / span);
    return rest < span ? rest : 0.0;
}

} // namespace

Encoder::Encoder(int pulses)
    : m_counts(4 * pulses)
{
}

std::uint16_t Encoder::count(double rotor_rad) const
{
    const double turn = wrapped(rotor_rad - m_zero_rad, kTurn) / kTurn;
    const int count = static_cast<int>(turn * m_counts);
    return static_cast<std::uint16_t>(std::clamp(count, 0, std::max(0, m_counts - 1)));
}

Hall::Hall(const SensorParameters &sensors)
    : m_present(sensors.hall)
    , m_placement_rad(sensors.hallPlacement_deg * std::numbers::pi / 180.0)
{
}

void Hall::place(double electrical_rad)
{
    m_sixths = wrapped((electrical_rad - m_placement_rad) * (6.0 / kTurn), 6.0);
}

void Hall::turn(double by_rad, double step_s)
{
    if (!m_present)
        return;
    const double from = m_sixths, to = from + by_rad * (6.0 / kTurn);
    const double crossed = std::floor(to) - std::floor(from);
    m_reading.sinceEdge_s += step_s;
    if (crossed != 0.0) {
        const double edge = crossed > 0.0 ? std::floor(to) : std::floor(to) + 1.0;
        const double after_s = std::clamp((to - edge) / (to - from), 0.0, 1.0) * step_s;
        m_reading.lastPeriod_s =
            m_reading.edges == 0 ? 0.0 : (m_reading.sinceEdge_s - after_s) / std::abs(crossed);
        m_reading.sinceEdge_s = after_s;
        m_reading.edges += static_cast<std::uint32_t>(std::min(std::abs(crossed), 1e6));
    }
    m_sixths = wrapped(to, 6.0);
}

HallReading Hall::reading() const
{
    HallReading reading = m_reading;
    if (m_present)
        reading.code = kForward[static_cast<std::size_t>(m_sixths)];
    return reading;
}

} // namespace simulation
