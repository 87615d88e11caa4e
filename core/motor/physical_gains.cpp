#include "motor/physical_gains.h"

#include <cmath>
#include <numbers>

namespace motor {

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
