#include "scope/xy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scope {

using capture::Channel;

namespace {

/// Reads a channel at rising times.
class HeldValue {
public:
    explicit HeldValue(const Channel &channel, Nanos from)
        : m_channel(channel)
        , m_next(channel.atOrAfter(from))
    {
    }
    /// What the sample before says, while it holds.
    std::optional<double> at(Nanos time)
    {
        while (m_next < m_channel.end() && m_channel.timeOf(m_next) <= time)
            ++m_next;
        if (m_next == m_channel.begin() || time >= m_channel.holdUntil(m_next - 1))
            return std::nullopt;
        return m_channel.at(m_next - 1);
    }

private:
    const Channel &m_channel;
    Index m_next;
};

bool wraps(double before, double now, double turn)
{
    return turn > 0.0 && std::abs(now - before) > turn / 2;
}

} // namespace

XyTrace xyTrace(
    const Channel &x, const Channel &y, Nanos from, Nanos to, const XySettings &settings)
{
    const SampleRange rangeX(x, from, to);
    const SampleRange rangeY(y, from, to);
    const bool xIsClock = rangeX.end() - rangeX.begin() >= rangeY.end() - rangeY.begin();
    const SampleRange &clock = xIsClock ? rangeX : rangeY;
    const Channel &other = xIsClock ? y : x;
    XyTrace result;
    if (clock.empty() || other.empty())
        return result;
    const std::uint64_t count = clock.end() - clock.begin();
    const auto most = static_cast<std::uint64_t>(std::max<std::size_t>(settings.most, 2));
    result.every = static_cast<std::size_t>((count + most - 1) / most);
    result.points.reserve(static_cast<std::size_t>(count / result.every) + 1);
    HeldValue held(other, from);
    bool broken = true;
    double beforeX = 0.0;
    double beforeY = 0.0;
    std::uint64_t instant = 0;
    clock.visit([&](double /*seconds*/, double value, bool joined) {
        // To the nanosecond, so that samples of one tick meet whatever the rate.
        const Nanos time = clock.channel().timeOf(clock.begin() + instant);
        const std::optional<double> second = held.at(time);
        broken = broken || !joined || !second;
        if (second) {
            const XyPoint point{
                xIsClock ? value : *second, xIsClock ? *second : value, false, time};
            // Wraps are looked for between neighbours, not between the points that are left.
            broken = broken || wraps(beforeX, point.x, settings.turnX)
                || wraps(beforeY, point.y, settings.turnY);
            beforeX = point.x;
            beforeY = point.y;
            if (instant % result.every == 0) {
                result.points.push_back(point);
                result.points.back().first = broken;
                broken = false;
            }
        }
        ++instant;
    });
    return result;
}

std::array<XyPoint, 6> voltageHexagon(double busVolts)
{
    std::array<XyPoint, 6> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double angle = static_cast<double>(i) * std::numbers::pi / 3;
        corners[i] = {
            busVolts * 2 / 3 * std::cos(angle), busVolts * 2 / 3 * std::sin(angle), i == 0};
    }
    return corners;
}

double linearVoltage(double busVolts) { return busVolts / std::numbers::sqrt3; }

} // namespace scope
