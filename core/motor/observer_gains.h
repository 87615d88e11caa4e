// Gains of the sensorless state observer by pole placement. Pure functions.
// Source: MCSDK `parameters_conversion.h` (what the constants mean); the placement was derived and agrees with
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

} // namespace motor
