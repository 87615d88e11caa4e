// What follows from a motor's parameters: torque, voltage and time constants, base speed, and what looks wrong about
// them. Pure functions; phase values and peak amperes throughout.
// Source: the equations of a PMSM in rotor coordinates; features 6.4 and 6.9 (Ld and Ls swapped by ST's generator).
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace motor {

constexpr double kRadpsPerRpm = 0.10471975511965977; ///< pi / 30

/// Whether a figure is there: a number above 0.
inline bool known(double value) { return std::isfinite(value) && value > 0.0; }

/// 0: not known. Datasheets often give line-to-line values: R and L are twice these.
struct MotorParameters {
    double polePairs = 0.0;
    double rs_ohm = 0.0;
    double lq_h = 0.0;
    double ld_h = 0.0;
    double flux_wb = 0.0; ///< of the magnets, linked with a phase, peak
    double nominalCurrent_a = 0.0; ///< peak
};

// The ways people give the strength of the magnets. Pole pairs > 0; forgetting them is the usual mistake.
double fluxOfKe_wb(double ke_vrmsPerKrpm, double polePairs); ///< Ke: rms, line to line, as ST
double keOfFlux_vrmsPerKrpm(double flux_wb, double polePairs);
double fluxOfKv_wb(double kv_rpmpv, double polePairs); ///< KV: rpm per volt, peak, line to line
double kvOfFlux_rpmpv(double flux_wb, double polePairs);
double ktOfFlux_nmpa(double flux_wb, double polePairs); ///< torque per peak ampere

/// Flux in the "rated flux" of a board's motor configuration [Wb]; 0: unknown.
/// @param perHertz  it is in V/Hz, as HSO firmware has it; else it is Ke (V rms line to line per 1000 rpm)
double fluxOfConfiguration_wb(double ratedFlux, double polePairs, bool perHertz);

/// Torque with reluctance: 3/2 p (flux Iq + (Ld - Lq) Id Iq).
double torque_nm(const MotorParameters &motor, double iq_a, double id_a = 0.0);

/// Empty where a parameter is missing.
struct MotorConstants {
    std::optional<double> kt_nmpa;
    std::optional<double> ke_vrmsPerKrpm;
    std::optional<double> kv_rpmpv;
    std::optional<double> timeConstantQ_s; ///< Lq / Rs
    std::optional<double> timeConstantD_s;
    /// Highest speed with nominal current and no flux weakening, the phase voltage being Vbus / sqrt(3).
    std::optional<double> baseSpeed_rpm;
};
/// @param bus_v  0: not known
MotorConstants motorConstants(const MotorParameters &motor, double bus_v);

enum class MotorWarning : std::uint8_t {
    PolePairsMissing, ///< not a whole number from 1 to 50
    ResistanceImplausible, ///< missing, or outside 0.1 mOhm to 1 kOhm
    InductanceImplausible, ///< missing, or outside 100 nH to 10 H
    FluxImplausible, ///< missing, or outside 1 uWb to 10 Wb
    NominalCurrentImplausible, ///< missing, or outside 1 mA to 5 kA
    LdAboveLq, ///< swapped? ST's generator does that, and no magnet motor is so
    TimeConstantImplausible, ///< L / R outside 10 us to 1 s
    NominalCurrentBeyondDrive, ///< more than the drive can measure
    SpeedBeyondBaseSpeed, ///< the highest speed needs flux weakening
};

/// What to compare the motor with. 0: not known, nothing is said about it.
struct DriveLimits {
    double bus_v = 0.0;
    double maxCurrent_a = 0.0;
    double maxSpeed_rpm = 0.0;
};

/// In the order of the enumeration; empty: nothing to be seen.
std::vector<MotorWarning> checkMotor(const MotorParameters &motor, const DriveLimits &drive);

} // namespace motor
