// A small motor of many poles, as tests/data/invented/quad11.json: at its higher speeds it turns by more than 20
// electrical degrees within a control period, and all of its currents swing through zero within one.
#pragma once

#include "simulation/plant/presets.h"

namespace support {

inline simulation::PlantParameters fastMotor()
{
    simulation::PlantParameters plant = *simulation::findPreset("pm24");
    plant.inverter.supply_v = 11.0;
    simulation::MotorParameters &motor = plant.motor;
    motor.polePairs = 7;
    motor.rs_ohm = 0.11;
    motor.ld_h = motor.lq_h = 18e-6;
    motor.flux_wb = 0.46e-3;
    motor.inertia_kgm2 = 3e-6;
    motor.viscous_nms = 5e-7;
    motor.coulomb_nm = 0.8e-3;
    motor.nominal_a = 5.0;
    motor.maxSpeed_rpm = 13000;
    return plant;
}

} // namespace support
