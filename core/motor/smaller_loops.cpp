#include "motor/smaller_loops.h"

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

PiGains fluxWeakeningGains(const PiGains &digits, const PowerStage &stage, double period_s)
{
    const double perVolt = 1.0 / stage.realOhms();
    return {digits.kp * perVolt, digits.ki * perVolt / period_s};
}

PidGains positionGains(const PidGains &digits, const PowerStage &stage, double period_s)
{
    const double perRadian = 65536.0 / (2.0 * std::numbers::pi) / stage.digitsPerAmp;
    return {
        digits.kp * perRadian, digits.ki * perRadian / period_s, digits.kd * perRadian * period_s};
}

PllForecast pllForecast(const PiGains &digits, double controlPeriod_s, double share)
{
    constexpr double kFullScale = 32767.0, kSpeedRoom = 1.2;
    const double radians = 2.0 * std::numbers::pi / 65536.0 * kFullScale * share / kSpeedRoom;
    const double natural = std::sqrt(digits.ki * radians); // radians a period
    return {natural / controlPeriod_s, natural > 0.0 ? digits.kp * radians / (2.0 * natural) : 0.0};
}

} // namespace motor
