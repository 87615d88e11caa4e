// Above the speed where the bus is used up: a negative d current that keeps the voltage at its target, and what it
// leaves of the q current. Runs at 1 kHz. Source: firmware 6.x, flux weakening; FLUXWK_* registers.
#pragma once

#include "simulation/maths/fixed_point.h"
#include "simulation/maths/pi.h"
#include "simulation/signals.h"

namespace simulation {

class FluxWeakening {
public:
    void clear();
    /// Every control period: the voltage that was asked for; it is averaged.
    void watch(Qd voltage);
    /// The reference that is driven: d not above what flux weakening wants, q within the rest of `currentLimit`.
    /// `demagnetising`: how far below zero d may go, digits, not negative.
    Qd step(Qd wanted, std::int32_t currentLimit, std::int32_t demagnetising, const Tuning &tuning,
        Signals &out);

private:
    std::int32_t m_q = 0, m_d = 0; ///< averaged voltage with 8 more bits
    Pi m_loop;
};

} // namespace simulation
