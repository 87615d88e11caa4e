// What the gains of the smaller loops mean in SI units: flux weakening, position, the observer's PLL. Pure functions.
// Source: what the firmware's regulators take and give (digits of voltage, current and angle), as simulation/firmware has
// it; MCSDK scales the observer's back-EMF to 1.2 times the highest speed.
#pragma once

#include "motor/current_loop.h"

namespace motor {

/// Of flux weakening, from a voltage that is missing to a current: A/V and A/(V s).
/// @param digits  numerator over divisor
/// @param period_s  of the speed loop; both scales of the stage > 0
PiGains fluxWeakeningGains(const PiGains &digits, const PowerStage &stage, double period_s);

struct PidGains {
    double kp = 0.0, ki = 0.0, kd = 0.0;
};
/// From an angle of the shaft to a current: A/rad, A/(rad s), A s/rad.
PidGains positionGains(const PidGains &digits, const PowerStage &stage, double period_s);

/// A loop of the second order.
struct PllForecast {
    double natural_radps = 0.0;
    double damping = 0.0;
};
/// It depends on the speed, with which the back-EMF grows.
/// @param share  of the highest speed, > 0
PllForecast pllForecast(const PiGains &digits, double controlPeriod_s, double share);

} // namespace motor
