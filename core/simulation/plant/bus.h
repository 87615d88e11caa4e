// The bus between supply and bridge: a capacitor, fed through the source's resistance, emptied by bridge and board.
//
//   C v' = (supply - v)/R - v/bleeder - bridge current;  the first term is 0 where it would be negative, unless the
//   supply absorbs: what a braking motor returns then stays in the capacitor and raises v.
// Exact over a step of constant bridge current, whatever R C is.
#pragma once

#include "simulation/plant/parameters.h"

namespace simulation {

class Bus {
public:
    explicit Bus(const InverterParameters &inverter);

    void prepare(double step_s); ///< before the steps of a period
    void step(double bridge_a);

    /// What that current into the bus adds to its voltage in a step, if nothing else takes it.
    double rise_v(double into_a) const { return into_a * m_step_s / m_capacitance_f; }

    double voltage_v() const { return m_v; }
    double meanVoltage_v() const { return m_mean_v; } ///< over the last step
    double capacitor_j() const { return 0.5 * m_capacitance_f * m_v * m_v; }
    struct Work {
        double supply_j = 0.0, source_j = 0.0, board_j = 0.0;
    };
    const Work &work() const { return m_work; } ///< since the start

private:
    /// What the capacitor sees besides the bridge: where a current leads it, and how much of its way there is left at
    /// the end of a step, and in its mean.
    struct Path {
        double resistance_ohm = 0.0, feed_a = 0.0, kept = 1.0, meanKept = 1.0;
    };
    Path path(bool fed) const;
    void relax(const Path &path, double bridge_a);

    double m_supply_v, m_capacitance_f;
    double m_source_s, m_bleeder_s; ///< conductances
    bool m_absorbs;
    double m_step_s = 0.0;
    Path m_fed, m_alone;
    double m_v, m_mean_v;
    Work m_work;
};

} // namespace simulation
