// The table of motors. Invented machines with the figures of real classes; no maker's data sheet is copied.
// The inverters read at least two and a half times the nominal current.
#include "simulation/plant/presets.h"

#include <algorithm>
#include <array>

namespace simulation {

namespace {

PlantParameters pm24()
{
    return {}; // the defaults of parameters.h
}

/// An outrunner with a propeller: 590 rpm/V, hardly any inductance, 84 cogs, a load that grows with the square.
PlantParameters prop12()
{
    PlantParameters p;
    p.motor = {.name = "Sim outrunner 12V",
        .polePairs = 7,
        .rs_ohm = 0.06,
        .ld_h = 30e-6,
        .lq_h = 30e-6,
        .flux_wb = 1.34e-3,
        .inertia_kgm2 = 2e-5,
        .viscous_nms = 5e-6,
        .coulomb_nm = 2e-3,
        .cogging_nm = 1.5e-3,
        .coggingPerTurn = 84,
        .nominal_a = 12.0,
        .maxSpeed_rpm = 5000.0,
        .copperMass_kg = 0.02,
        .coolingTime_s = 60.0};
    p.inverter.supply_v = 12.0;
    p.inverter.supplyResistance_ohm = 0.03;
    p.inverter.busCapacitance_f = 470e-6;
    p.inverter.supplyAbsorbs = true; // a battery
    p.inverter.deadTime_s = 400e-9;
    p.inverter.switchResistance_ohm = 0.005;
    p.inverter.amplifierGain = 16.0;
    p.inverter.busRange_v = 30.0;
    p.load.fan_nms2 = 2.5e-7;
    return p;
}

/// A small servo: light rotor, 1000-line encoder.
PlantParameters servo24()
{
    PlantParameters p;
    p.motor = {.name = "Sim servo 24V",
        .polePairs = 5,
        .rs_ohm = 0.18,
        .ld_h = 0.35e-3,
        .lq_h = 0.35e-3,
        .flux_wb = 6.4e-3,
        .inertia_kgm2 = 2.5e-5,
        .viscous_nms = 6e-5,
        .coulomb_nm = 0.012,
        .cogging_nm = 4e-3,
        .coggingPerTurn = 60,
        .nominal_a = 7.0,
        .maxSpeed_rpm = 3600.0,
        .copperMass_kg = 0.15,
        .coolingTime_s = 400.0};
    p.sensors.encoderPulses = 1000;
    p.inverter.amplifierGain = 12.0;
    return p;
}

/// A blower with Hall sensors: 36 V, low inductance, a fan on the shaft.
PlantParameters blower36()
{
    PlantParameters p;
    p.motor = {.name = "Sim blower 36V",
        .polePairs = 4,
        .rs_ohm = 0.11,
        .ld_h = 0.16e-3,
        .lq_h = 0.16e-3,
        .flux_wb = 9.5e-3,
        .inertia_kgm2 = 1.5e-4,
        .viscous_nms = 1e-4,
        .coulomb_nm = 0.02,
        .nominal_a = 12.0,
        .maxSpeed_rpm = 4500.0,
        .copperMass_kg = 0.2,
        .coolingTime_s = 120.0};
    p.sensors.hall = true;
    p.inverter.supply_v = 36.0;
    p.inverter.supplyResistance_ohm = 0.04;
    p.inverter.amplifierGain = 16.0;
    p.inverter.busRange_v = 63.26;
    p.load.fan_nms2 = 1.2e-6;
    return p;
}

/// Magnets buried in the rotor: Lq well above Ld and saturating, speed beyond the voltage by weakening the flux.
PlantParameters ipm48()
{
    PlantParameters p;
    p.motor = {.name = "Sim IPM 48V",
        .polePairs = 4,
        .rs_ohm = 0.08,
        .ld_h = 0.25e-3,
        .lq_h = 0.6e-3,
        .flux_wb = 0.014,
        .saturation_a = 30.0,
        .inertia_kgm2 = 3e-4,
        .viscous_nms = 3e-4,
        .coulomb_nm = 0.04,
        .cogging_nm = 0.015,
        .coggingPerTurn = 24,
        .nominal_a = 20.0,
        .maxSpeed_rpm = 5000.0,
        .copperMass_kg = 0.5,
        .coolingTime_s = 600.0};
    p.inverter.supply_v = 48.0;
    p.inverter.supplyResistance_ohm = 0.03;
    p.inverter.busCapacitance_f = 2.2e-3;
    p.inverter.switchResistance_ohm = 0.004;
    p.inverter.shunt_ohm = 0.001;
    p.inverter.amplifierGain = 20.0;
    p.inverter.busRange_v = 82.5;
    p.inverter.heatsinkResistance_kpw = 2.0;
    p.inverter.heatsinkCapacity_jpk = 80.0;
    return p;
}

const std::array<Preset, 5> &table()
{
    static const std::array<Preset, 5> kPresets{{
        {"pm24", "24 V, 4 pole pairs, 5 A, sensorless", pm24()},
        {"prop12", "12 V outrunner with propeller, 7 pole pairs, 12 A, sensorless", prop12()},
        {"servo24", "24 V servo, 5 pole pairs, 7 A, encoder of 1000 pulses", servo24()},
        {"blower36", "36 V blower with fan, 4 pole pairs, 12 A, Hall sensors", blower36()},
        {"ipm48", "48 V salient motor, 4 pole pairs, 20 A, sensorless", ipm48()},
    }};
    return kPresets;
}

} // namespace

std::span<const Preset> presets() { return table(); }

const PlantParameters *findPreset(std::string_view name)
{
    const auto found = std::ranges::find(table(), name, &Preset::name);
    return found != table().end() ? &found->parameters : nullptr;
}

} // namespace simulation
