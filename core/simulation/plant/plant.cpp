// One control period of motor, bridge and bus, step by step.
#include "simulation/plant/plant.h"

#include <algorithm>
#include <cmath>

namespace simulation {

namespace {

constexpr int kFacedEvery = 16; ///< periods: roundings of so few are nothing, a sine is slow

/// Cogs pull a rotor without current to where they do not pull: it rests at one of them.
double restingAngle(const MotorParameters &motor, double share)
{
    const double turns = motor.cogging_nm > 0.0
        ? std::floor(share * motor.coggingPerTurn) / motor.coggingPerTurn
        : share;
    return turns * kTurn;
}

} // namespace

Plant::Plant(const PlantParameters &parameters, std::uint64_t seed)
    : m_parameters(parameters)
    , m_rotor(parameters.motor, parameters.load)
    , m_windings(parameters.motor)
    , m_legs(parameters.inverter, std::min(parameters.motor.ld_h, parameters.motor.lq_h))
    , m_bus(parameters.inverter)
    , m_sensing(parameters.inverter, seed)
    , m_encoder(parameters.sensors.encoderPulses)
    , m_hall(parameters.sensors)
    , m_winding(parameters.inverter.ambient_c, parameters.motor.copperMass_kg * kCopper_jpkgk,
          parameters.motor.coolingTime_s)
    , m_heatsink(parameters.inverter.ambient_c, parameters.inverter.heatsinkCapacity_jpk,
          parameters.inverter.heatsinkResistance_kpw * parameters.inverter.heatsinkCapacity_jpk)
{
    m_sensing.noise().bits(); // the first number of a small seed is not random yet
    m_rotor.place(restingAngle(parameters.motor, m_sensing.noise().share()), 0.0);
    m_encoder.powerUp(m_rotor.angle_rad());
    m_hall.place(angle_rad());
    faceAngle();
    sample();
}

void Plant::setLoadTorque(double nm)
{
    LoadParameters load = m_rotor.load();
    load.constant_nm = nm;
    m_rotor.setLoad(load);
}

void Plant::place(double electrical_rad, double speed_radps)
{
    m_rotor.place(electrical_rad / m_parameters.motor.polePairs, speed_radps);
    m_windings.open();
    m_phases = {};
    m_hall.place(angle_rad());
    faceAngle();
    sample();
}

double Plant::angle_rad() const
{
    const double turns = m_parameters.motor.polePairs * m_rotor.angle_rad() / kTurn;
    return (turns - std::floor(turns)) * kTurn;
}

void Plant::faceAngle()
{
    m_sinceFaced = 0;
    m_rotor.faceCogs();
    m_frame = Rotation::of(angle_rad());
}

void Plant::advance(double dt_s)
{
    if (!(dt_s > 0.0))
        return;
    const double wanted = std::ceil(dt_s / kMaxStep_s - 1e-6);
    const int steps = static_cast<int>(std::clamp<double>(wanted, kSubSteps, 1e9));
    const double h_s = dt_s / steps;
    const double copper_j = m_sum.copper_j, inverter_j = m_sum.inverter_j;
    m_windings.prepare(h_s, m_winding.temperature_c(), m_parameters.inverter.switchResistance_ohm);
    m_legs.prepare(dt_s, m_bus.voltage_v());
    if (!m_legs.bridge().on && atRest() && m_rotor.stays()) {
        rest(dt_s);
    } else {
        m_bus.prepare(h_s);
        for (int i = 0; i < steps; ++i) {
            if (m_legs.bridge().on)
                drive(h_s);
            else
                freewheel(h_s);
        }
    }
    m_winding.warm(m_sum.copper_j - copper_j, dt_s);
    m_heatsink.warm(m_sum.inverter_j - inverter_j, dt_s);
    m_rotor.wrap();
    if (++m_sinceFaced == kFacedEvery)
        faceAngle();
    sample();
}

void Plant::turn(double h_s)
{
    const double by_rad = m_parameters.motor.polePairs * m_rotor.drift(h_s);
    const Rotation by = Rotation::small(by_rad);
    m_frame = m_frame.then(by);
    m_windings.turn(by);
    m_hall.turn(by_rad, h_s);
}

void Plant::drive(double h_s)
{
    const Phases volts = m_legs.voltages(m_phases, m_bus.voltage_v());
    turn(h_s);
    m_windings.drive(volts.stationary().in(m_frame));
    m_phases = Phases::from(Stationary::from(m_windings.current(), m_frame));
    book(m_legs.flow(Phases::from(Stationary::from(m_windings.meanCurrent(), m_frame))), h_s);
}

void Plant::freewheel(double h_s)
{
    const bool carries = m_windings.carriesCurrent();
    const double emf_v =
        std::abs(m_rotor.speed_radps()) * m_parameters.motor.polePairs * m_windings.magnetFlux_wb();
    turn(h_s);
    if (!carries && m_legs.blocks(emf_v, m_bus.voltage_v())) {
        m_windings.open();
        m_phases = {};
        book({}, h_s);
        return;
    }
    // The diodes meet the bus as it will be, or it would gain what the motor did not lose.
    const double most_a =
        std::max({std::abs(m_phases.a), std::abs(m_phases.b), std::abs(m_phases.c)});
    const double bus_v = m_bus.voltage_v() + m_bus.rise_v(most_a);
    const Legs::Freewheel end = m_legs.freewheel(m_windings.imply(), m_frame, bus_v);
    m_windings.settle(end.current);
    m_phases = Phases::from(Stationary::from(m_windings.current(), m_frame));
    book(end.flow, h_s);
}

/// The capacitor alone goes on, which one step holds exactly.
void Plant::rest(double dt_s)
{
    m_bus.prepare(dt_s);
    m_bus.step(0.0);
    m_hall.turn(0.0, dt_s);
    m_windings.open();
    m_phases = {};
}

void Plant::book(Legs::Flow flow, double h_s)
{
    const Dq mean = m_windings.meanCurrent();
    const double square = 1.5 * (mean.d * mean.d + mean.q * mean.q) * h_s;
    m_sum.copper_j += m_windings.resistance_ohm() * square;
    m_sum.inverter_j += flow.lost_w * h_s + m_parameters.inverter.switchResistance_ohm * square;
    m_rotor.kick(m_windings.torque_nm(), h_s);
    m_bus.step(flow.bus_a);
    m_sum.bridge_j += flow.bus_a * m_bus.meanVoltage_v() * h_s;
}

void Plant::sample()
{
    m_sensing.sample(m_phases.a, m_phases.b, m_bus.voltage_v(), m_heatsink.temperature_c());
}

Energies Plant::energies() const
{
    Energies all = m_sum;
    all.supply_j = m_bus.work().supply_j;
    all.source_j = m_bus.work().source_j;
    all.board_j = m_bus.work().board_j;
    all.mechanical_j = m_rotor.work().mechanical_j;
    all.friction_j = m_rotor.work().friction_j;
    all.load_j = m_rotor.work().load_j;
    all.driven_j = m_rotor.work().driven_j;
    all.capacitor_j = m_bus.capacitor_j();
    all.field_j = m_windings.field_j();
    all.kinetic_j = m_rotor.kinetic_j();
    all.cogging_j = m_rotor.cogging_j();
    return all;
}

HeatStore::HeatStore(double ambient_c, double capacity_jpk, double cooling_s)
    : m_ambient_c(ambient_c)
    , m_capacity_jpk(capacity_jpk)
    , m_cooling_s(cooling_s)
{
}

void HeatStore::warm(double energy_j, double over_s)
{
    if (m_capacity_jpk <= 0.0)
        return;
    // One step backward, so that no step is too long.
    m_rise_k += energy_j / m_capacity_jpk;
    if (m_cooling_s > 0.0)
        m_rise_k /= 1.0 + over_s / m_cooling_s;
}

} // namespace simulation
