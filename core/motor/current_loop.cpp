#include "motor/current_loop.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace motor {

namespace {

constexpr double kBusDigits = 65536.0; // the bus voltage in ST's rule
constexpr double kPhaseDigits = 32767.0; // the largest phase voltage, Vbus / sqrt(3)
constexpr int kMostSamples = 100'000;

/// When the samples first reach `level`, in samples; negative if they do not.
double crossing(const std::vector<double> &samples, double level)
{
    for (std::size_t i = 1; i < samples.size(); ++i) {
        if (samples[i] >= level)
            return static_cast<double>(i - 1)
                + (level - samples[i - 1]) / (samples[i] - samples[i - 1]);
    }
    return -1.0;
}

} // namespace

double PowerStage::ruleOhms() const { return bus_v / kBusDigits * digitsPerAmp; }

double PowerStage::realOhms() const
{
    return bus_v / (std::numbers::sqrt3 * kPhaseDigits) * digitsPerAmp;
}

PiGains currentGains(const CurrentPlant &plant, double bandwidth_radps)
{
    return {plant.inductance_h * bandwidth_radps, plant.rs_ohm * bandwidth_radps};
}

PiGains currentDigits(const PiGains &gains, const PowerStage &stage)
{
    return {gains.kp / stage.ruleOhms(), gains.ki * stage.controlPeriod_s / stage.ruleOhms()};
}

double ruleBandwidth_radps(double kpDigits, const CurrentPlant &plant, const PowerStage &stage)
{
    return kpDigits * stage.ruleOhms() / plant.inductance_h;
}

double realBandwidth_radps(double kpDigits, const CurrentPlant &plant, const PowerStage &stage)
{
    return kpDigits * stage.realOhms() / plant.inductance_h;
}

double bandwidthLimit_radps(double controlRate_hz) { return 0.6 * controlRate_hz; }

double currentPhaseMargin_deg(double realBandwidth_radps, double controlPeriod_s)
{
    return 90.0 - 1.5 * controlPeriod_s * realBandwidth_radps * 180.0 / std::numbers::pi;
}

void measureStep(StepPrediction &step)
{
    const double low = crossing(step.response, 0.1), high = crossing(step.response, 0.9);
    step.rise_s = low >= 0.0 && high >= 0.0 ? (high - low) * step.period_s : 0.0;
    double top = 1.0;
    for (const double value : step.response)
        top = std::max(top, value);
    step.overshoot = top - 1.0;
}

StepPrediction predictCurrentStep(const PiGains &digits, const CurrentPlant &plant,
    const PowerStage &stage, int samples, Acting acting)
{
    // Within a period the voltage stands still, and the current runs towards voltage / Rs.
    const double keep = std::exp(-stage.controlPeriod_s * plant.rs_ohm / plant.inductance_h);
    const double perVolt = plant.rs_ohm > 0.0 ? (1.0 - keep) / plant.rs_ohm
                                              : stage.controlPeriod_s / plant.inductance_h;
    const double ohms = stage.realOhms();

    StepPrediction step;
    step.period_s = stage.controlPeriod_s;
    double current = 0.0, integral = 0.0, volts = 0.0;
    for (int i = 0; i < std::clamp(samples, 2, kMostSamples); ++i) {
        step.response.push_back(current);
        const double error = 1.0 - current;
        integral += digits.ki * error;
        const double decided = ohms * (digits.kp * error + integral);
        current = keep * current + perVolt * (acting == Acting::Late ? volts : decided);
        current = std::clamp(current, -kFar, kFar); // an unstable loop need not go on for ever
        volts = decided;
    }
    measureStep(step);
    return step;
}

double fullScaleCurrent_a(const CurrentSensing &sensing)
{
    if (!(sensing.shunt_ohm > 0.0) || !(sensing.gain > 0.0) || !(sensing.reference_v > 0.0))
        return 0.0;
    const double amps = sensing.reference_v / (2.0 * sensing.shunt_ohm * sensing.gain);
    return std::isfinite(amps) ? amps : 0.0;
}

} // namespace motor
