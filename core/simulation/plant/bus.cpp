// The capacitor's exponential over a step, with the supply or without.
#include "simulation/plant/bus.h"

#include <algorithm>
#include <cmath>

namespace simulation {

Bus::Bus(const InverterParameters &inverter)
    : m_supply_v(inverter.supply_v)
    , m_capacitance_f(inverter.busCapacitance_f)
    , m_source_s(1.0 / inverter.supplyResistance_ohm)
    , m_bleeder_s(1.0 / inverter.bleeder_ohm)
    , m_absorbs(inverter.supplyAbsorbs)
    , m_v(m_supply_v * m_source_s / (m_source_s + m_bleeder_s))
    , m_mean_v(m_v)
{
}

Bus::Path Bus::path(bool fed) const
{
    const double conductance_s = m_bleeder_s + (fed ? m_source_s : 0.0);
    const double share = m_step_s * conductance_s / m_capacitance_f; // of its time constant
    return {1.0 / conductance_s, fed ? m_supply_v * m_source_s : 0.0, std::exp(-share),
        -std::expm1(-share) / share};
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
    const double end_v = (path.feed_a - bridge_a) * path.resistance_ohm;
    const double away_v = m_v - end_v;
    m_mean_v = end_v + away_v * path.meanKept;
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
    m_work.board_j += m_mean_v * m_mean_v * m_bleeder_s * m_step_s;
    if (!fed)
        return;
    const double across_v = m_supply_v - m_mean_v;
    const double source_as = across_v * m_source_s * m_step_s;
    m_work.supply_j += m_supply_v * source_as;
    m_work.source_j += across_v * source_as;
}

} // namespace simulation
