// The capacitor's exponential over a step, with the supply or without.
#include "simulation/plant/bus.h"

#include <algorithm>
#include <cmath>

namespace simulation {

Bus::Bus(const InverterParameters &inverter)
    : m_supply_v(inverter.supply_v)
    , m_source_ohm(inverter.supplyResistance_ohm)
    , m_bleeder_ohm(inverter.bleeder_ohm)
    , m_capacitance_f(inverter.busCapacitance_f)
    , m_absorbs(inverter.supplyAbsorbs)
    , m_v(m_supply_v * m_bleeder_ohm / (m_source_ohm + m_bleeder_ohm))
    , m_mean_v(m_v)
{
}

Bus::Path Bus::path(bool fed) const
{
    Path path;
    path.conductance_s = 1.0 / m_bleeder_ohm + (fed ? 1.0 / m_source_ohm : 0.0);
    path.feed_a = fed ? m_supply_v / m_source_ohm : 0.0;
    path.kept = std::exp(-m_step_s * path.conductance_s / m_capacitance_f);
    return path;
}

void Bus::prepare(double step_s)
{
    if (step_s == m_step_s)
        return;
    m_step_s = step_s;
    m_fed = path(true);
    m_alone = path(false);
}

void Bus::relax(const Path &path, double bridge_a)
{
    const double end_v = (path.feed_a - bridge_a) / path.conductance_s;
    const double away_v = m_v - end_v;
    m_mean_v =
        end_v + away_v * (1.0 - path.kept) * m_capacitance_f / (path.conductance_s * m_step_s);
    m_v = std::max(0.0, end_v + away_v * path.kept);
}

void Bus::step(double bridge_a)
{
    const double before_v = m_v;
    bool fed = m_absorbs || m_v < m_supply_v;
    if (fed) {
        relax(m_fed, bridge_a);
        if (!m_absorbs && m_v > m_supply_v) { // the diode closed on the way
            m_v = before_v;
            fed = false;
        }
    }
    if (!fed)
        relax(m_alone, bridge_a);
    m_work.board_j += m_mean_v * m_mean_v / m_bleeder_ohm * m_step_s;
    if (!fed)
        return;
    const double source_a = (m_supply_v - m_mean_v) / m_source_ohm;
    m_work.supply_j += m_supply_v * source_a * m_step_s;
    m_work.source_j += m_source_ohm * source_a * source_a * m_step_s;
}

} // namespace simulation
