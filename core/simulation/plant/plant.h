// A motor on its power stage, as the firmware of a board meets it: three duties go in, digits come out. Physics only;
// it knows no controller and has no clock. Call order: setBridge, advance(period), read the converters.
//
// Voltages, currents and fluxes are amplitude-invariant; the electrical angle is that of the q axis from phase A, and
// with positive speed phase B follows A by 120 degrees (ST's convention: d is 90 degrees behind q):
//   i_a = q cos + d sin        i_beta = -(2 i_b + i_a)/sqrt 3 = d cos - q sin
//
// `advance` splits its time into at least kSubSteps equal steps h. In each:
//   angle    += p w h                                       p pole pairs, w mechanical speed at mid-step
//   flux      turned back by p w h, exactly; then flux += h (v - R i), see windings.h
//   torque    = 3/2 p (flux_d i_q - flux_q i_d)
//   w         by torque, cogging, friction and load, see rotor.h
//   bus       by what the bridge takes or returns, see bus.h and legs.h
// Position and speed leapfrog, the flux uses the trapezoidal rule: second order, and stable for every L/R. So the
// ledger of energies closes, which the tests check.
#pragma once

#include "simulation/plant/bus.h"
#include "simulation/plant/legs.h"
#include "simulation/plant/parameters.h"
#include "simulation/plant/position_sensors.h"
#include "simulation/plant/rotor.h"
#include "simulation/plant/sensing.h"
#include "simulation/plant/windings.h"

#include <cstdint>

namespace simulation {

/// Where the energy of a simulated drive went since it was switched on, in joules.
///
///   supply     = source + board + bridge + (change of capacitor)
///   bridge     = inverter + copper + mechanical + (change of field)
///   mechanical = friction + load - driven + (change of kinetic and cogging)
/// The first line of each pair of sides is summed up step by step by itself, so that a test can compare them.
struct Energies {
    // Sums.
    double supply_j = 0.0; ///< out of the ideal source
    double source_j = 0.0; ///< lost in the source's resistance
    double board_j = 0.0; ///< taken by the board itself
    double bridge_j = 0.0; ///< from the bus into the bridge; less when it returns
    double inverter_j = 0.0; ///< lost in switches and diodes
    double copper_j = 0.0;
    double mechanical_j = 0.0; ///< air gap torque times way
    double friction_j = 0.0; ///< viscous and dry friction of the motor
    double load_j = 0.0; ///< brake and fan
    double driven_j = 0.0; ///< put in by drive_nm
    // Stored now.
    double capacitor_j = 0.0;
    double field_j = 0.0; ///< of the currents; the magnets' own is not counted
    double kinetic_j = 0.0;
    double cogging_j = 0.0; ///< 0 at a detent
};

/// Something that warms up by losses and cools towards the ambient: one heat capacity, one path.
///   C T' = P - C (T - ambient)/tau
class HeatStore {
public:
    /// @param capacity_jpk  0: stays at the ambient temperature
    /// @param cooling_s     time constant; 0: never cools
    HeatStore(double ambient_c, double capacity_jpk, double cooling_s);

    void warm(double energy_j, double over_s);
    double temperature_c() const { return m_ambient_c + m_rise_k; }

private:
    double m_ambient_c, m_capacity_jpk, m_cooling_s;
    double m_rise_k = 0.0;
};

inline constexpr double kCopper_jpkgk = 385.0; ///< specific heat

class Plant {
public:
    static constexpr int kSubSteps = 10; ///< at least, in a call of advance
    static constexpr double kMaxStep_s = 6.25e-6;

    /// The rotor rests at an angle drawn from `seed`, the capacitor is charged, everything is at ambient temperature.
    /// Every random figure comes from `seed`: same calls, same numbers.
    /// Precondition: impossibleParameter(parameters) is empty.
    Plant(const PlantParameters &parameters, std::uint64_t seed);

    /// What the bridge does from now on; duties are cut to 0..1, not-a-number is 0.5.
    void setBridge(const Bridge &bridge) { m_legs.set(bridge); }
    /// Moves on by one control period, which is one PWM period too, and samples the converters at its end.
    /// Cost: some 0.6 us for 62.5 us; up to 4 us while the diodes rectify, little of it at rest with the bridge off.
    void advance(double dt_s);

    void setLoad(const LoadParameters &load) { m_rotor.setLoad(load); }
    /// The brake alone, see LoadParameters::constant_nm.
    void setLoadTorque(double nm);
    /// Puts the rotor at an electrical angle (of the q axis) with a mechanical speed; the bridge's currents end.
    void place(double electrical_rad, double speed_radps = 0.0);

    const PlantParameters &parameters() const { return m_parameters; }
    const LoadParameters &load() const { return m_rotor.load(); }

    // What the converters and timers of the board deliver.
    std::uint16_t currentA() const { return m_sensing.currentA(); }
    std::uint16_t currentB() const { return m_sensing.currentB(); }
    double bus_v() const { return m_sensing.bus_v(); }
    double heatsink_c() const { return m_sensing.heatsink_c(); }
    /// 0 to 4 encoderPulses - 1; 0 where the rotor was when the power came. 0 without an encoder.
    std::uint16_t encoderCount() const { return m_encoder.count(m_rotor.angle_rad()); }
    /// Code 0 without Hall sensors.
    HallReading hall() const { return m_hall.reading(); }

    // The truth, which no firmware sees.
    double angle_rad() const; ///< electrical, of the q axis, 0 to 2 pi
    double rotor_rad() const { return m_rotor.angle_rad(); } ///< mechanical, 0 to 2 pi
    double speed_radps() const { return m_rotor.speed_radps(); } ///< mechanical
    double id_a() const { return m_windings.current().d; }
    double iq_a() const { return m_windings.current().q; }
    Phases phases_a() const { return m_phases; }
    double torque_nm() const { return m_windings.torque_nm(); } ///< of the air gap, without cogging
    double winding_c() const { return m_winding.temperature_c(); }
    double trueBus_v() const { return m_bus.voltage_v(); }
    bool atRest() const { return m_rotor.speed_radps() == 0.0 && !m_windings.carriesCurrent(); }
    Energies energies() const;

private:
    void turn(double h_s);
    void drive(double h_s);
    void freewheel(double h_s);
    void rest(double dt_s);
    void book(Legs::Flow flow, double h_s); ///< heat, speed, bus: the end of every step
    void faceAngle(); ///< anew from the rotor's angle, so that no rounding adds up
    void sample();

    PlantParameters m_parameters;
    Rotor m_rotor;
    Windings m_windings;
    Legs m_legs;
    Bus m_bus;
    Sensing m_sensing;
    Encoder m_encoder;
    Hall m_hall;
    HeatStore m_winding, m_heatsink;
    Energies m_sum; ///< since the start; the stored ones are looked up when asked for

    Rotation m_frame; ///< of the electrical angle
    int m_sinceFaced = 0; ///< periods
    Phases m_phases;
};

} // namespace simulation
