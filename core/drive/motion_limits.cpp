#include "drive/motion_limits.h"

#include <algorithm>
#include <cmath>

namespace drive {

namespace {

bool known(double limit, double ceiling)
{
    return std::isfinite(limit) && limit > 0.0 && limit <= ceiling;
}

/// The lower of what is known and what the user allows; 0 if nothing is known.
double lower(double known, double user) { return user > 0.0 ? std::min(known, user) : known; }

} // namespace

double plausible(double value, double ceiling) { return known(value, ceiling) ? value : 0.0; }

std::vector<LimitGap> gapsIn(const MotorLimits &limits)
{
    std::vector<LimitGap> gaps;
    if (!known(limits.maxSpeedRpm, kHighestRpm))
        gaps.push_back(LimitGap::MaxSpeed);
    if (!known(limits.maxCurrentAmps, kHighestAmps))
        gaps.push_back(LimitGap::MaxCurrent);
    if (!known(limits.nominalCurrentAmps, kHighestAmps))
        gaps.push_back(LimitGap::NominalCurrent);
    return gaps;
}

MotionBounds boundsOf(const MotorLimits &limits, const UserLimits &user, bool expert)
{
    const auto bound = [&](double limit, double ceiling) {
        return known(limit, ceiling) ? limit : expert ? ceiling : 0.0;
    };
    const double most = bound(limits.maxCurrentAmps, kHighestAmps);
    const double nominal = bound(limits.nominalCurrentAmps, kHighestAmps);
    return {lower(bound(limits.maxSpeedRpm, kHighestRpm), user.maxSpeedRpm),
        lower(std::min(most, nominal), user.maxCurrentAmps)};
}

MotionBounds realBoundsOf(const MotorLimits &limits, const UserLimits &user)
{
    const MotionBounds told = boundsOf(limits, user, false);
    return {told.rpm > 0.0 ? told.rpm : user.maxSpeedRpm,
        told.amps > 0.0 ? told.amps : user.maxCurrentAmps};
}

bool isPlausible(const UserLimits &user)
{
    return std::isfinite(user.maxSpeedRpm) && user.maxSpeedRpm >= 0.0
        && std::isfinite(user.maxCurrentAmps) && user.maxCurrentAmps >= 0.0;
}

bool isPlausible(const CurrentScale &scale)
{
    constexpr double kLeast = 1e-3;
    return scale.fullScaleAmps == 0.0
        || (scale.fullScaleAmps >= kLeast && scale.fullScaleAmps <= kHighestAmps);
}

double setPointPerDigit(
    const catalog::RegisterInfo &info, const catalog::Scale &scale, const MotorLimits &limits)
{
    constexpr double kSecondsPerMinute = 60.0;
    const double factor = std::isfinite(scale.factor) && scale.factor > 0.0 ? scale.factor : 0.0;
    switch (info.setPoint) {
    case catalog::SetPoint::Speed:
        if (scale.unit == "rpm")
            return factor;
        if (scale.unit == "Hz" && limits.polePairs > 0.0) // electrical
            return factor * kSecondsPerMinute / limits.polePairs;
        return 0.0;
    case catalog::SetPoint::Current:
        return scale.unit == "A" ? factor : 0.0;
    case catalog::SetPoint::Torque:
        return scale.unit == "N m" && limits.torquePerAmp > 0.0 ? factor / limits.torquePerAmp
                                                                : 0.0;
    case catalog::SetPoint::None:
        break;
    }
    return 0.0;
}

} // namespace drive
