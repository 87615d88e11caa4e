#include "motor/observer_gains.h"

#include <cmath>
#include <numbers>

namespace motor {

ObserverGains observerGains(
    const CurrentPlant &plant, double controlPeriod_s, const ObserverScale &scale)
{
    const double t = controlPeriod_s;
    const double z1 = (1.0 - plant.rs_ohm * t / plant.inductance_h) / 4.0, z2 = 1.0 / 4.0;
    const double k1 = (z1 + z2 - 2.0) / t + plant.rs_ohm / plant.inductance_h;
    const double k2 = plant.inductance_h * (1.0 - z1 - z2 + z1 * z2) / (t * t);
    return {scale.f1 * k1 * t, scale.f2 * k2 * t * scale.maxCurrent_a / scale.maxBemf_v};
}

double maxObserverBemf_v(double maxSpeed_rpm, double ke_vrmsPerKrpm)
{
    return std::floor(
        maxSpeed_rpm * 1.2 * ke_vrmsPerKrpm * std::numbers::sqrt2 / (1000.0 * std::numbers::sqrt3));
}

} // namespace motor
