// How long a motor is waited for, and when it is where it was to go: for experiments, and for a command that stops a
// motor before one and starts it again behind it. Time is an argument.
#pragma once

#include "base/time.h"
#include "drive/event.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lab {

/// A start, with its alignment and its rev-up.
inline constexpr Duration kRunsWithin = std::chrono::seconds(10);
inline constexpr Duration kReachesWithin = std::chrono::seconds(5); ///< after the ramp
inline constexpr Duration kRestsWithin = std::chrono::seconds(5); ///< after its stop
/// An idle motor is not at rest: an alignment would catch a rotor that coasts, and a rev-up lose it. Heavy ones take
/// seconds; without a sensor nothing tells when they stand.
inline constexpr Duration kCoastsSeen = std::chrono::seconds(10),
                          kCoastsUnseen = std::chrono::seconds(4);

/// What set-points differ by in the board's digits is no difference.
inline double toleratedRpm(const drive::MotorLimits &limits)
{
    return std::max(1.0, limits.speedStepRpm);
}

/// @param speed  rpm, signed, as measured; empty: not known, and so not near
inline bool isNear(std::optional<double> speed, double rpm, const drive::MotorLimits &limits)
{
    constexpr double kDigits = 3.0, kShare = 0.03;
    const double most = std::max(kDigits * toleratedRpm(limits), kShare * std::abs(rpm));
    return speed && std::abs(*speed - rpm) <= most;
}

/// @param speed  rpm by a sensor; one that is not known is 0. @param most_rpm  that the motor may turn at
inline bool isStill(std::optional<double> speed, double most_rpm, const drive::MotorLimits &limits)
{
    constexpr double kShare = 0.01;
    return std::abs(speed.value_or(0.0)) <= std::max(toleratedRpm(limits), kShare * most_rpm);
}

/// A reference of a current that is more than a few digits.
inline bool flows(double amps, const drive::MotorLimits &limits)
{
    constexpr double kShare = 0.005; // of the nominal one
    return std::abs(amps) > kShare * limits.nominalCurrentAmps;
}

/// A speed that only passes by is not reached.
class Settling {
public:
    /// @param near  it is, now  @return  it has been for a while
    bool settled(bool near, TimePoint now)
    {
        constexpr Duration kSteadyFor = std::chrono::milliseconds(200);
        m_since = near ? std::min(m_since, now) : TimePoint::max();
        return near && now - m_since >= kSteadyFor;
    }

private:
    TimePoint m_since = TimePoint::max();
};

} // namespace lab
