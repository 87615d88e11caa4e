#include "motor/ramp.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace motor {

double quantisedSpeed_rpm(double rpm, double step_rpm)
{
    if (!std::isfinite(rpm))
        return 0.0;
    if (!(step_rpm > 0.0))
        return rpm;
    const double most = kMostSpeedSteps * step_rpm,
                 whole = std::trunc(std::clamp(rpm, -most, most));
    return std::trunc(whole / step_rpm) * step_rpm + 0.0;
}

std::vector<RampPoint> rampPreview(
    double from_rpm, double to_rpm, double duration_s, double step_rpm, std::size_t mostPoints)
{
    const double from = quantisedSpeed_rpm(from_rpm, step_rpm),
                 to = quantisedSpeed_rpm(to_rpm, step_rpm);
    const double duration = std::isfinite(duration_s) ? std::max(0.0, duration_s) : 0.0;
    std::vector<RampPoint> points{{0.0, from}};
    const double stairs = std::abs(to - from) / step_rpm;
    if (duration > 0.0 && stairs > 0.0) {
        const double room = static_cast<double>(std::max<std::size_t>(mostPoints, 2)) - 2.0;
        const double shown = std::min(stairs - 1.0, room);
        for (double i = 1.0; i <= shown; ++i) {
            const double stair = std::round(i * stairs / (shown + 1.0));
            const double share = stair / stairs;
            points.push_back({share * duration, from + std::copysign(stair, to - from) * step_rpm});
        }
    }
    points.push_back({duration, to});
    return points;
}

double positionShare(double timeShare)
{
    const double t = std::clamp(timeShare, 0.0, 1.0);
    return t * t * t * (10.0 - t * (15.0 - 6.0 * t));
}

double positionPeakSpeed_rpm(double way_rad, double duration_s)
{
    constexpr double kPeakOverMean = 1.875; // half-way: 30/16
    const double way = std::abs(way_rad);
    if (way == 0.0)
        return 0.0;
    return kPeakOverMean * way / std::max(0.0, duration_s) * 60.0 / (2.0 * std::numbers::pi);
}

double rampAcceleration_rpmps(double from_rpm, double to_rpm, double duration_s, double step_rpm)
{
    const double change =
        quantisedSpeed_rpm(to_rpm, step_rpm) - quantisedSpeed_rpm(from_rpm, step_rpm);
    return change == 0.0 ? 0.0 : change / std::max(0.0, duration_s);
}

} // namespace motor
