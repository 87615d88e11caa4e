// A row of a table of latencies: how many, and their median, p99, p99.9 and worst.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace bench {

/// @param sorted  not empty
inline double quantile(const std::vector<double> &sorted, double part)
{
    const auto last = static_cast<double>(sorted.size() - 1);
    return sorted[static_cast<std::size_t>(std::lround(part * last))];
}

/// @param times  milliseconds, in any order
inline void printTimes(const char *what, std::vector<double> times)
{
    std::sort(times.begin(), times.end());
    if (times.empty())
        std::printf("%-32s  none\n", what);
    else
        std::printf(
            "%-32s %5zu  p50 %7.2f ms  p90 %7.2f ms  p99 %7.2f ms  p99.9 %7.2f ms  max %7.2f ms\n",
            what, times.size(), quantile(times, 0.5), quantile(times, 0.9), quantile(times, 0.99),
            quantile(times, 0.999), times.back());
}

} // namespace bench
