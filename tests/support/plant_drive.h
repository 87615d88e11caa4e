// Drives a simulated motor as a controller with a perfect sensor would: voltages in rotor coordinates become duties.
// For tests of the plant alone.
#pragma once

#include "simulation/plant/plant.h"

#include <cmath>
#include <numbers>

namespace plant_drive {

inline constexpr double kPeriod_s = 1.0 / 16000.0;
inline constexpr double kTurn = 2.0 * std::numbers::pi;

/// Duties for a stationary vector at an electrical angle, around one half.
inline simulation::Bridge vector(double vd_v, double vq_v, double electrical_rad, double bus_v)
{
    const auto leg = [&](double phase_rad) {
        const double at = electrical_rad - phase_rad;
        return 0.5 + (vq_v * std::cos(at) + vd_v * std::sin(at)) / bus_v;
    };
    return {.on = true, .a = leg(0.0), .b = leg(kTurn / 3.0), .c = leg(2.0 * kTurn / 3.0)};
}

/// One period with these voltages, seen from where the rotor will be at its middle.
inline void step(simulation::Plant &plant, double vd_v, double vq_v)
{
    const double ahead_rad =
        0.5 * kPeriod_s * plant.speed_radps() * plant.parameters().motor.polePairs;
    plant.setBridge(vector(vd_v, vq_v, plant.angle_rad() + ahead_rad, plant.trueBus_v()));
    plant.advance(kPeriod_s);
}

inline void steps(simulation::Plant &plant, double vd_v, double vq_v, double seconds)
{
    const int count = static_cast<int>(std::lround(seconds / kPeriod_s));
    for (int i = 0; i < count; ++i)
        step(plant, vd_v, vq_v);
}

/// All switches open for a while.
inline void coast(simulation::Plant &plant, double seconds)
{
    plant.setBridge({});
    const int count = static_cast<int>(std::lround(seconds / kPeriod_s));
    for (int i = 0; i < count; ++i)
        plant.advance(kPeriod_s);
}

/// A motor without what its model adds to the textbook: no dead time, no switch resistance, no cogs, no warming, and a
/// supply that does not give way.
inline simulation::PlantParameters plain()
{
    simulation::PlantParameters p;
    p.motor.copperMass_kg = 0.0;
    p.inverter.ambient_c = 20.0;
    p.inverter.deadTime_s = 0.0;
    p.inverter.switchResistance_ohm = 0.0;
    p.inverter.supplyResistance_ohm = 1e-3;
    p.inverter.supplyAbsorbs = true;
    return p;
}

/// So much dry friction that the rotor stays where it is placed.
inline simulation::PlantParameters locked(simulation::PlantParameters p)
{
    p.motor.coulomb_nm = 1e3;
    return p;
}

} // namespace plant_drive
