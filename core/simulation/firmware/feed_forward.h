// What the voltages must be for the speed and the currents that are wanted, by the motor's equations: given to the
// current loops in advance, they have less to do. Runs at 1 kHz. Source: FF_* registers; features 6.4.
#pragma once

#include "simulation/maths/fixed_point.h"
#include "simulation/plant/parameters.h"
#include "simulation/signals.h"

namespace simulation {

class FeedForward {
public:
    /// The constants of FF_1Q, FF_1D and FF_2: Ld, Lq and the magnets' flux, such that with the speed in 1/65536 turn a
    /// period, currents in digits and the bus in digits of its converter
    ///   vd = -speed iq FF_1D / (16 bus)     vq = (speed id FF_1Q / 16 + speed FF_2) / bus       in digits.
    static void design(const PlantParameters &plant, double hfHz, Tuning &tuning);

    void clear();
    /// Every control period: the voltages that were driven.
    void watch(Qd voltage);
    /// What to add to the outputs of the current loops.
    Qd step(Qd reference, std::int16_t speed_dpp, std::uint16_t bus, const Tuning &tuning,
        Signals &out);
    Qd voltage() const { return m_voltage; }

private:
    Qd m_voltage;
    std::int32_t m_q = 0, m_d = 0; ///< averages of what the loops added, with 8 more bits
};

} // namespace simulation
