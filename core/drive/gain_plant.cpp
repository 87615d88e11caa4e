#include "drive/gain_plant.h"

namespace drive {

motor::GainPlant gainPlant(const MotorFacts &facts)
{
    motor::GainPlant plant;
    plant.motor = facts.motor;
    plant.inertia_kgm2 = facts.inertia_kgm2;
    plant.stage = {facts.bus_v, facts.ampsPerDigit > 0.0 ? 1.0 / facts.ampsPerDigit : 0.0,
        facts.controlPeriod_s};
    plant.speedPeriod_s = facts.speedPeriod_s;
    plant.speedDelay_s = facts.speedDelay_s;
    plant.bandwidthGuide_radps = facts.bandwidthGuide_radps;
    return plant;
}

} // namespace drive
