// From motor, power stage and bandwidth to the integers that the firmware is built with. Pure functions in SI units.
// Source: features 6.2, 6.3, 6.6; each rule was checked there against the numbers of generated projects.
#pragma once

#include "simulation/maths/pi.h"
#include "simulation/maths/state_observer.h"

namespace simulation {

/// How digits relate to amps and volts.
struct CurrentSensing {
    double bus_v = 24.0; ///< nominal
    double shunt_ohm = 3e-3;
    double amplifierGain = 9.14;
    double reference_v = 3.3; ///< of the converter: its full range

    double digitsPerAmp() const { return 65536.0 * shunt_ohm * amplifierGain / reference_v; }
    double maxCurrent_a() const { return reference_v / (2.0 * shunt_ohm * amplifierGain); }
    /// AB of ST's rule: volts a digit of the modulation times digits an amp.
    double loopGain() const { return bus_v * shunt_ohm * amplifierGain / reference_v; }
};

/// A gain as the firmware holds it: numerator / 2^shift.
struct Fraction {
    std::int16_t numerator = 0;
    int shift = 0;
};

/// `gain` to nearest with 2^shift below the line, or with the largest smaller power with which the numerator fits 16
/// bits; gains past 32767 are cut. shift: 0..15.
Fraction fractionOf(double gain, int shift);

/// Pole-zero cancellation for a closed loop of first order with `bandwidth_radps`: ls * wc / AB, rs * wc / (hf AB),
/// with 2^10 and 2^14 below the line where they fit. `ls_h`: Lq for the q axis, Ld for the d axis. ST's rule takes bus
/// / 2^16 for a digit of voltage, but the modulation makes bus / (sqrt(3) 2^15) of it: on a board the loop is faster
/// than asked: by 2 / sqrt(3), 15 %.
Pi::Gains currentGains(
    double ls_h, double rs_ohm, double bandwidth_radps, const CurrentSensing &sensing, double hfHz);

struct SpeedLoop {
    double inertia_kgm2 = 0.0; ///< of rotor and load
    double torqueConstant_nmPerA = 0.0; ///< 1.5 * pole pairs * flux
    double currentBandwidth_radps = 1500.0;
    double filter_s = 0.0; ///< delay of the speed measurement
    double hfHz = 16000.0, mfHz = 1000.0;
    /// D of the symmetrical optimum, above 1: phase margin atan(d) - atan(1/d).
    double damping = 3.0;

    double lag_s() const
    {
        return 1.0 / currentBandwidth_radps + filter_s + 1.5 / hfHz + 0.5 / mfHz;
    }
    double crossover_radps() const { return 1.0 / (damping * lag_s()); }
};

/// Symmetrical optimum: Kp = 1 / (d K tau), Ki = Kp / (d^2 tau), K = torque constant / inertia; in s16A per 0.1 Hz,
/// with 2^9 and 2^14 below the line where they fit.
Pi::Gains speedGains(const SpeedLoop &loop, const CurrentSensing &sensing);

struct ObserverDesign {
    double rs_ohm = 0.0, ls_h = 0.0;
    double hfHz = 16000.0;
    double maxCurrent_a = 0.0; ///< 32768 digits
    /// Phase peak at 1.2 times the maximum speed; ST's tool cuts it to whole volts.
    double maxBemf_v = 0.0;
    /// Full scale of the bus converter / sqrt(3); ST's tool cuts it to whole volts.
    double maxVoltage_v = 0.0;
    int f1Shift = 14, f2Shift = 13; ///< the largest to use
};

/// C1, C3, C5 of the motor (cut to whole numbers), gains that move the observer's poles to a quarter of the motor's:
/// K1 T = z1 + z2 - 2 + rs T / ls, K2 T = ls (1 - z1) (1 - z2) / T with z1 = (1 - rs T / ls) / 4, z2 = 1/4.
/// F1 and F2 are halved until everything fits 16 bits; what does not even with 1 is cut.
ObserverConstants observerGains(const ObserverDesign &design);

/// A PLL of the second order with natural frequency `wn_radps` where the back-EMF has `bemf_digits`; both its poles
/// scale with the speed. Denominators 2^14 and 2^15 where they fit.
Pi::Gains pllGains(double wn_radps, double damping, double bemf_digits, double hfHz);

} // namespace simulation
