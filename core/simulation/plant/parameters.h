// The figures of a simulated motor, its power stage, its sensors and its load, in SI. Plain values, checked by
// `impossibleParameter` only; what they do is told where they are used. The defaults are the 24 V motor `pm24`.
// Per phase and star equivalent throughout: data sheets that measure between two terminals give twice Rs and L.
#pragma once

#include <string>
#include <string_view>

namespace simulation {

constexpr double kTurn = 6.283185307179586; ///< rad

/// A permanent magnet synchronous motor.
struct MotorParameters {
    std::string name = "Sim PMSM 24V"; ///< as the board tells it, 23 bytes at most
    int polePairs = 4;
    double rs_ohm = 0.35; ///< a phase, at 20 C
    double ld_h = 0.6e-3; ///< along the magnets
    double lq_h = 0.6e-3; ///< across them; larger than ld_h in a salient motor
    double flux_wb = 6.5e-3; ///< of the magnets, peak, a phase: V/(rad/s) electrical
    double saturation_a = 0.0; ///< q current at which flux over current is 0.8 lq_h; 0: never
    double inertia_kgm2 = 5e-5; ///< rotor and what is fixed to it
    double viscous_nms = 1.2e-4; ///< torque per rad/s; holds the iron losses too
    double coulomb_nm = 0.025; ///< dry friction: against any motion, holds a rotor at rest
    double cogging_nm = 0.0; ///< peak
    /// Periods in a mechanical turn; slots and poles' least common multiple.
    int coggingPerTurn = 24;
    double nominal_a = 5.0; ///< peak
    double maxSpeed_rpm = 4000.0;
    double copperMass_kg = 0.12; ///< what heats up; 0: the winding stays at the ambient temperature
    double coolingTime_s = 240.0; ///< time constant towards the ambient temperature; 0: never cools
};

/// What tells the rotor's position beside the observers.
struct SensorParameters {
    int encoderPulses = 0; ///< a turn, counted four times each; 0: no encoder
    bool hall = false;
    double hallPlacement_deg = 300.0; ///< electrical angle at which code 4 turns into 5
};

/// The power stage with its supply, and the amplifiers and converters that look at it.
struct InverterParameters {
    double supply_v = 24.0; ///< without load; also the nominal voltage
    double supplyResistance_ohm = 0.05; ///< source and leads
    double busCapacitance_f = 1e-3;
    double bleeder_ohm = 1000.0; ///< what the board itself takes from the bus
    bool supplyAbsorbs = false; ///< else a diode: what the motor returns stays in the capacitor
    double deadTime_s = 750e-9; ///< both switches of a leg open, twice a period
    double switchResistance_ohm = 0.008; ///< of a closed switch, either direction
    double diodeDrop_v = 0.8;
    double shunt_ohm = 0.003;
    double amplifierGain = 9.14;
    double converterReference_v = 3.3; ///< full scale of all converters
    int converterBits = 16; ///< of the current converters; left-aligned to 16
    double offset_digits = 0.0; ///< of the amplifiers: added to both current readings
    double noise_digits = 4.0; ///< of the current readings, evenly spread to either side
    double busRange_v = 63.26; ///< bus voltage at full scale
    double busNoise_v = 0.02; ///< evenly spread to either side
    double ambient_c = 25.0;
    double heatsinkResistance_kpw = 4.0; ///< to the ambient
    double heatsinkCapacity_jpk = 25.0; ///< 0: stays at the ambient temperature
    double heatsinkNoise_c = 0.1;

    /// Amps that read as 32768 digits, half of the converter's range.
    double maxReadable_a() const
    {
        return converterReference_v / (2.0 * shunt_ohm * amplifierGain);
    }
    double digitsPerAmp() const { return 32768.0 / maxReadable_a(); }
};

/// What the shaft is coupled to. `constant_nm` and the fan only ever brake: they oppose motion in either direction
/// and cannot turn a resting rotor. `drive_nm` is a machine that pushes, in the sense of its sign.
struct LoadParameters {
    double constant_nm = 0.0; ///< a friction brake; its sign does not matter
    double fan_nms2 = 0.0; ///< torque over the square of the speed in rad/s
    double drive_nm = 0.0;
};

struct PlantParameters {
    MotorParameters motor;
    SensorParameters sensors;
    InverterParameters inverter;
    LoadParameters load;
};

/// The name of the first member that no machine can have (`rs_ohm`, ...); empty if there is none. Code that takes
/// parameters from a file asks this before it makes a Plant of them.
std::string_view impossibleParameter(const PlantParameters &parameters);

} // namespace simulation
