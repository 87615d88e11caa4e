// The current loop from the motor's resistance and inductance: regulator gains for a bandwidth, what the firmware's
// digits make of them, and the step that is to be expected. Pure functions.
//
// The regulator cancels the motor's pole (Kp / Ki = L / Rs), so that the loop is of first order. ST's generator counts
// the bus voltage as 2^16 digits; the modulator makes Vbus / sqrt(3) of 32767 digits. The loop is therefore faster by
// 2 / sqrt(3) than the bandwidth its gains were generated for: both are told.
// Source: MCSDK documentation, "Flux and torque PI gains determination" and "Measurement units"; checked against
// generated projects (tests).
#pragma once

#include <cstdint>
#include <vector>

namespace motor {

constexpr double kFar = 1e3; ///< times the step: an unstable loop is not followed further

/// One axis of the motor, a phase. A salient motor has another inductance in q than in d.
struct CurrentPlant {
    double rs_ohm = 0.0;
    double inductance_h = 0.0;
};

/// What digits are worth on a board.
struct PowerStage {
    double bus_v = 0.0; ///< nominal
    double digitsPerAmp = 0.0; ///< 65536 * shunt * amplification / ADC reference
    double controlPeriod_s = 0.0; ///< of the current loop

    /// Ohms that a regulator gain of 1 digit per digit stands for in ST's rule (A * B in its documentation).
    double ruleOhms() const;
    /// Ohms that it really makes at the motor.
    double realOhms() const;
};

/// A PI regulator. Physical: V/A and V/(A s), or A/(rad/s) and A/rad; in digits: output per error, and what the
/// integral grows per error and period.
struct PiGains {
    double kp = 0.0;
    double ki = 0.0;
};

/// Kp = L w, Ki = Rs w. @param bandwidth_radps  of the closed loop, > 0
PiGains currentGains(const CurrentPlant &plant, double bandwidth_radps);

/// Physical gains as the firmware counts them, by ST's rule: Kp / AB and Ki T / AB.
PiGains currentDigits(const PiGains &gains, const PowerStage &stage);

/// The bandwidth [rad/s] for which ST's rule gives this Kp (in digits); the one asked for.
double ruleBandwidth_radps(double kpDigits, const CurrentPlant &plant, const PowerStage &stage);
/// The bandwidth [rad/s] that the loop has with it.
double realBandwidth_radps(double kpDigits, const CurrentPlant &plant, const PowerStage &stage);

/// Bandwidth beyond which the delay of 1.5 control periods takes too much phase: 0.6 of the control rate, in rad/s.
double bandwidthLimit_radps(double controlRate_hz);

/// Phase margin [degrees] of a loop of that real bandwidth, the motor's pole cancelled: 90 less what 1.5 control
/// periods take.
double currentPhaseMargin_deg(double realBandwidth_radps, double controlPeriod_s);

struct StepPrediction {
    double period_s = 0.0;
    std::vector<double> response; ///< at the samples 0, T, 2 T, ...; the step goes from 0 to 1 at 0
    double rise_s = 0.0; ///< 10 to 90 %, interpolated between samples; 0: not reached
    double overshoot = 0.0; ///< beyond 1, as a fraction
};

/// Fills in rise and overshoot from the response.
void measureStep(StepPrediction &step);

/// When the voltage that was decided on acts. A board whose timer takes new duties over at once is Prompt (the
/// simulated one is), one that takes them a period later is Late; shipped boards lie between the two.
enum class Acting : std::uint8_t { Prompt, Late };

/// The step of the current as the samples will show it, with the motor at rest (no back-EMF). Voltage limits are not in
/// it: it holds for small steps.
/// @param digits  gains as the firmware has them
/// @param samples  how many, 2 to 100000
StepPrediction predictCurrentStep(const PiGains &digits, const CurrentPlant &plant,
    const PowerStage &stage, int samples, Acting acting = Acting::Prompt);

/// The measuring circuit of the currents, for boards that do not tell their scale. Source: the workbench of the motor
/// control SDK: the converter sees the shunts' voltage amplified about its middle.
struct CurrentSensing {
    double shunt_ohm = 0.0;
    double gain = 0.0; ///< of the amplifier, with its divider if it has one
    double reference_v = 0.0; ///< of the converter: its whole range
};

/// Current of the greatest reading, 32768 digits: reference / (2 shunt gain). 0 unless all are above 0.
double fullScaleCurrent_a(const CurrentSensing &sensing);

} // namespace motor
