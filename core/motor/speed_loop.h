// The speed loop by the symmetrical optimum: gains from torque constant, inertia, the loop's small lags and one damping
// factor. Pure functions.
//
// Plant K / s with K = Kt / J, behind a lag tau. With the damping factor d the crossover lies at 1 / (d tau), the
// regulator's zero at 1 / (d^2 tau); d = 2 is quick and rings, d = 4 is calm.
// Source: TI, "Teaching your PI controller to behave", parts III and IV; derived again. Digits as in features 6.3.
#pragma once

#include "motor/current_loop.h"

namespace motor {

struct SpeedPlant {
    double kt_nmpa = 0.0; ///< torque per peak ampere of Iq
    double inertia_kgm2 = 0.0; ///< rotor and load
};

/// Everything between the current reference and the measured speed that is too quick to be a state of its own [s]:
/// current loop, filter of the speed, the current loop's delay and half a period of the speed loop.
double speedLoopLag_s(
    double currentBandwidth_radps, double filter_s, double controlPeriod_s, double speedPeriod_s);

/// Kp = 1 / (d K tau) in A/(rad/s), Ki = Kp / (d^2 tau) in A/rad. @param damping  d, > 1
PiGains speedGains(const SpeedPlant &plant, double lag_s, double damping);

/// As the firmware counts them: error in 0.1 Hz, output in digits of the current.
PiGains speedDigits(const PiGains &gains, double digitsPerAmp, double speedPeriod_s);
/// The other way round: A/(rad/s) and A/rad of gains in digits.
PiGains speedGainsOf(const PiGains &digits, double digitsPerAmp, double speedPeriod_s);

/// Where the open loop with these gains has magnitude 1, and its phase margin there.
struct LoopMargin {
    double crossover_radps = 0.0;
    double phase_deg = 0.0;
};
/// @param gains  physical, Kp > 0, Ki >= 0; everything else > 0
LoopMargin speedMargin(const PiGains &gains, const SpeedPlant &plant, double lag_s);

/// What lies between the current reference and the measured speed, for a prediction in time. A design may take both as
/// one lag; the step of an average waits longer and then climbs faster than that.
struct SpeedPath {
    double quick_s = 0.0; ///< one time constant for the current loop and what is as short, > 0
    double average_s = 0.0; ///< length of the average that the speed is; it delays by half of it
};

/// The step of the speed as it is measured, the current having room. It holds while Kp times the step stays below the
/// current limit. Friction and load are not in it.
/// @param gains  physical
/// @param duration_s  of the prediction, > 0
/// @param samples  how many, 2 to 10000; the steps in between are as fine as they need to be
StepPrediction predictSpeedStep(const PiGains &gains, const SpeedPlant &plant,
    const SpeedPath &path, double duration_s, int samples);

/// Overshoot, as a fraction, of a step of the reference behind a prefilter 1 / (1 + s d^2 tau), which a ramp of the
/// set-point resembles.
double filteredStepOvershoot(double damping);

} // namespace motor
