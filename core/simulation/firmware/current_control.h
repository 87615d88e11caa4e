// One control period of the currents, in the firmware's integers: Clarke, Park, two PIs, circle limitation, reverse
// Park, modulation. It knows no states and no sensor: the angle is an argument.
// Source: features 6.2; order and delays as in firmware 6.x.
#pragma once

#include "simulation/maths/fixed_point.h"
#include "simulation/maths/pi.h"
#include "simulation/maths/voltage.h"
#include "simulation/signals.h"

namespace simulation {

class CurrentControl {
public:
    explicit CurrentControl(std::uint16_t pwmPeriod);

    struct Frame {
        std::int16_t angle = 0; ///< of the rotor now
        std::int16_t perPeriod = 0; ///< how far it turns until the next period
    };

    void clear();
    /// Measured currents in, voltages out: `out.iAlpha` to `out.vBeta` are written.
    Duties step(
        Ab currents, Frame frame, Qd reference, Qd feedForward, const Tuning &tuning, Signals &out);
    /// The same with voltages given instead of controlled.
    Duties drive(Ab currents, Frame frame, Qd voltage, Signals &out);
    /// Only the transforms of what was measured.
    static void measure(Ab currents, std::int16_t angle, Signals &out);

private:
    Duties apply(Qd voltage, Frame frame, Signals &out) const;

    std::uint16_t m_pwmPeriod;
    Circle m_circle = circleOf(32767);
    Pi m_q, m_d;
};

} // namespace simulation
