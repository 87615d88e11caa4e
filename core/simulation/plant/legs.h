// The three legs of the inverter: duties become voltages, or diodes do. They keep no current; the windings do.
//
// Bridge on, averaged over the PWM period T:
//   duty seen = duty - td/T s(i), cut to 0..1        td dead time, s(i) = i/i0 cut to -1..1
//   voltage   = duty seen * bus - R i - 2 td/T diodeDrop s(i)
//   bus current = sum of duty seen * i
// s(i) stands for sign(i): within the ripple, i0 = bus T/(16 L), the current changes its sign in each period and the
// dead times cancel. Dead time itself loses nothing (the current takes the other rail); its diodes do.
//
// Bridge off, for each leg: i > 0 (into the motor): the lower diode, voltage = -drop; i < 0: the upper one, voltage =
// bus + drop; i = 0: anything between. With the currents at the end of the step, i = free + A v with A symmetric and
// positive semidefinite, that is a quadratic programme in three voltages with bounds, and has one solution. It only
// ever takes energy out of the motor, if `bus` is what the step will make of it. Switch resistance is counted with the
// windings' in both cases.
#pragma once

#include "simulation/plant/parameters.h"
#include "simulation/plant/rotation.h"
#include "simulation/plant/windings.h"

namespace simulation {

/// What the firmware's timers make of the six switches.
struct Bridge {
    bool on = false; ///< false: all switches open
    double a = 0.5, b = 0.5, c = 0.5; ///< share of the bus at each output over the control period
};

class Legs {
public:
    Legs(const InverterParameters &inverter, double leastInductance_h);

    void set(const Bridge &bridge);
    const Bridge &bridge() const { return m_bridge; }

    /// Before the steps of a period of `period_s`.
    void prepare(double period_s, double bus_v);

    /// The mean voltages of the outputs while `current` flows.
    Phases voltages(Phases current, double bus_v);
    struct Flow {
        double bus_a = 0.0; ///< out of the bus
        double lost_w = 0.0; ///< in diodes
    };
    /// What the voltages just asked for mean for bus and heat, when `mean` is what flowed.
    Flow flow(Phases mean) const;

    struct Freewheel {
        Dq current;
        Flow flow;
    };
    /// The currents at the end of a step with all switches open.
    Freewheel freewheel(const Windings::Implied &windings, Rotation frame, double bus_v);
    /// Whether back-EMF of that amplitude (a phase) can open no diode.
    bool blocks(double emf_v, double bus_v) const;

private:
    InverterParameters m_inverter;
    double m_leastInductance_h;
    Bridge m_bridge;
    double m_share = 0.0, m_drop_v = 0.0, m_perZero = 0.0; ///< of dead time; 1/A
    Phases m_seen, m_sign; ///< duties; s(i)
    Phases m_open_v; ///< where the diodes settled last, to start from
};

} // namespace simulation
