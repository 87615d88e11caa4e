// Gains of the smaller loops: the sensorless observer's by pole placement, and what those of flux weakening, position
// and the observer's PLL mean in SI units. Pure functions. Source: MCSDK `parameters_conversion.h` (what the constants
// mean; the observer's back-EMF is scaled to 1.2 times the highest speed); what the firmware's regulators take and give
// (digits of voltage, current and angle), as simulation/firmware has it. The placement was derived and agrees with
// generated projects (tests).
#pragma once

#include "motor/current_loop.h"

namespace motor {

/// The observer's own full scales: not those of the registers.
struct ObserverScale {
    double f1 = 16384.0, f2 = 8192.0; ///< fixed-point factors F1 and F2
    double maxCurrent_a = 0.0; ///< ADC reference / (2 * shunt * amplification)
    double maxBemf_v = 0.0; ///< maxObserverBemf_v()
};

struct ObserverGains {
    double gain1 = 0.0; ///< GAIN1, register STOPLL_C1; negative
    double gain2 = 0.0; ///< GAIN2, register STOPLL_C2
};

/// Poles at a quarter of those that the motor has by itself. @param controlPeriod_s  > 0
ObserverGains observerGains(
    const CurrentPlant &plant, double controlPeriod_s, const ObserverScale &scale);

/// Largest back-EMF of a phase [V] as the firmware counts it: at 1.2 times the highest speed, cut to whole volts.
/// @param ke_vrmsPerKrpm  line to line
double maxObserverBemf_v(double maxSpeed_rpm, double ke_vrmsPerKrpm);

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
