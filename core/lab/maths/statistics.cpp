#include "lab/maths/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lab {

double lastPlaceOf(const Estimate &estimate)
{
    if (!estimate.low || !estimate.high)
        return 0.0;
    const double half = (*estimate.high - *estimate.low) / 2.0;
    return half > 0.0 && std::isfinite(half) ? std::pow(10.0, std::floor(std::log10(half)) - 1.0)
                                             : 0.0;
}

/// Two-sided 95 % of Student's distribution: a table up to 30 degrees of freedom, behind it the series of Cornish and
/// Fisher, exact to 0.001 there. Source: Abramowitz and Stegun, Handbook of Mathematical Functions, 26.7.5 and table
/// 26.10.
double studentOf(std::size_t freedom)
{
    constexpr std::array kTable{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262,
        2.228, 2.201, 2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086, 2.080, 2.074,
        2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042};
    if (freedom <= kTable.size())
        return kTable[freedom - 1];
    constexpr double kNormal = 1.959964;
    return kNormal + (std::pow(kNormal, 3) + kNormal) / (4.0 * static_cast<double>(freedom));
}

namespace {

struct Moments {
    double mean = 0.0;
    double squares = 0.0; ///< of the distances from it
    double count = 0.0;
};

Moments momentsOf(std::span<const double> values)
{
    Moments found{0.0, 0.0, static_cast<double>(values.size())};
    for (const double value : values)
        found.mean += value / found.count;
    for (const double value : values)
        found.squares += (value - found.mean) * (value - found.mean);
    return found;
}

} // namespace

std::optional<Estimate> meanOf(std::span<const double> values)
{
    if (values.empty())
        return std::nullopt;
    const Moments all = momentsOf(values);
    if (values.size() == 1)
        return Estimate{all.mean, {}, {}};
    const double half =
        studentOf(values.size() - 1) * std::sqrt(all.squares / (all.count - 1.0) / all.count);
    return Estimate{all.mean, all.mean - half, all.mean + half};
}

std::optional<Estimate> meanOfBoth(std::span<const double> one, std::span<const double> other)
{
    if (one.empty() || other.empty())
        return meanOf(one.empty() ? other : one);
    const Moments a = momentsOf(one), b = momentsOf(other);
    const double mean = (a.mean + b.mean) / 2.0;
    const std::size_t freedom = one.size() + other.size() - 2;
    if (freedom == 0)
        return Estimate{mean, {}, {}};
    const double variance = (a.squares + b.squares) / static_cast<double>(freedom);
    const double half =
        studentOf(freedom) * std::sqrt(variance * (1.0 / a.count + 1.0 / b.count)) / 2.0;
    return Estimate{mean, mean - half, mean + half};
}

Estimate withScale(const Estimate &own, double scale)
{
    const double half = std::hypot((*own.high - *own.low) / 2.0, scale * own.value);
    return {own.value, own.value - half, own.value + half};
}

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1)
        return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2.0;
}

std::vector<std::size_t> outliersOf(std::span<const double> values, double resolution)
{
    constexpr std::size_t kLeast = 4; // of three, one is always far from the other two
    constexpr double kNormal = 1.4826, kFar = 3.5;
    std::vector<std::size_t> found;
    if (values.size() < kLeast)
        return found;
    const double median = medianOf({values.begin(), values.end()});
    std::vector<double> distances;
    for (const double value : values)
        distances.push_back(std::abs(value - median));
    const double limit = std::max(kFar * kNormal * medianOf(distances), resolution);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (distances[i] > limit)
            found.push_back(i);
    return found;
}

} // namespace lab
