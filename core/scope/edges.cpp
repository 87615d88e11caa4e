#include "scope/edges.h"

#include "scope/level_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scope {

namespace {

constexpr std::size_t kBins = 200; // 0.5 % of the height each
constexpr std::ptrdiff_t kNear = 10; // bins that count as the same level, 5 %

/// How often each level occurs, with the sums to take means from.
struct Histogram {
    std::array<double, kBins> counts{};
    std::array<double, kBins> sums{};
};

/// The level where the signal dwells in [first, last) of the bins; nullopt if it only passes.
std::optional<double> dwelling(const Histogram &histogram, std::size_t first, std::size_t last)
{
    const auto counts = histogram.counts.begin();
    const auto from = counts + static_cast<std::ptrdiff_t>(first);
    const auto to = counts + static_cast<std::ptrdiff_t>(last);
    const auto mode = std::max_element(from, to);
    double all = 0.0;
    double near = 0.0;
    double sum = 0.0;
    for (auto bin = from; bin != to; ++bin) {
        all += *bin;
        if (std::abs(bin - mode) <= kNear) {
            near += *bin;
            sum += histogram.sums[static_cast<std::size_t>(bin - counts)];
        }
    }
    if (near <= 0.0 || near < all / 2)
        return std::nullopt;
    return sum / near;
}

/// Where the straight line between two samples passes a level.
double crossingTime(
    Between between, double before, double beforeValue, double now, double value, double level)
{
    if (between == Between::Hold || value == beforeValue)
        return now;
    return before
        + (now - before) * std::clamp((level - beforeValue) / (value - beforeValue), 0.0, 1.0);
}

} // namespace

std::optional<SignalLevels> findLevels(const SampleRange &range)
{
    if (range.end() < range.begin() + 3)
        return std::nullopt;
    const SampleRange::Extremes extremes = range.extremes();
    const double height = extremes.max - extremes.min;
    if (!(height > 0.0))
        return std::nullopt;
    Histogram histogram;
    range.visit([&](double /*time*/, double value, bool /*joined*/) {
        const double place = (value - extremes.min) / height * double(kBins);
        const auto bin = std::min(static_cast<std::size_t>(std::max(place, 0.0)), kBins - 1);
        histogram.counts[bin] += 1.0;
        histogram.sums[bin] += value;
    });
    return SignalLevels{dwelling(histogram, 0, kBins / 2).value_or(extremes.min),
        dwelling(histogram, kBins / 2, kBins).value_or(extremes.max)};
}

Crossings findCrossings(const SampleRange &range, double level, double hysteresis)
{
    const Halves<double> halves{range.channel()};
    auto up = Crossing<double>::upwards(halves, level, hysteresis);
    auto down = Crossing<double>::downwards(halves, level, hysteresis);
    const Between between = range.between();
    Crossings result;
    double before = 0.0;
    double beforeValue = 0.0;
    range.visit([&](double time, double value, bool joined) {
        if (!joined)
            up.armed = down.armed = false;
        const bool rose = up.step(value);
        const bool fell = down.step(value);
        if (rose || fell) {
            std::vector<double> &list = rose ? result.rising : result.falling;
            if (list.size() < kMostCrossings)
                list.push_back(crossingTime(between, before, beforeValue, time, value, level));
        }
        before = time;
        beforeValue = value;
    });
    return result;
}

std::optional<Transition> findTransition(const SampleRange &range, double start, double end)
{
    const bool up = end > start;
    const auto past = [up](double value, double level) {
        return up ? value >= level : value <= level;
    };
    const Between between = range.between();
    std::optional<double> left;
    std::optional<Transition> result;
    double before = 0.0;
    double beforeValue = 0.0;
    range.visit([&](double time, double value, bool joined) {
        if (result)
            return;
        if (!joined || !past(value, start))
            left.reset();
        if (joined && !past(beforeValue, start) && past(value, start))
            left = crossingTime(between, before, beforeValue, time, value, start);
        if (left && past(value, end))
            result = {*left, crossingTime(between, before, beforeValue, time, value, end)};
        before = time;
        beforeValue = value;
    });
    return result;
}

} // namespace scope
