#include "lab/evaluation/flux_fit.h"

#include "lab/maths/least_squares.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lab {

std::optional<Estimate> fitFlux(std::span<const Segment> segments, double window_s)
{
    constexpr double kLeastCurrent = 0.15; // of the largest
    constexpr double kLeastRange = 0.3; // of the fastest speed
    constexpr std::size_t kCurrent = 0, kConstant = 1, kSpeed = 2, kCluster = 10;
    double most_a = 0.0;
    for (const Segment &segment : segments)
        for (const double amps : segment.values[0])
            most_a = std::max(most_a, std::abs(amps));
    Rows rows;
    double slowest = 1e9, fastest = 0.0;
    for (const Segment &segment : segments) {
        const auto length = static_cast<std::size_t>(std::lround(window_s / segment.step_s));
        for (std::size_t at = 0; length > 0 && at + length < segment.turned_deg.size();
             at += length) {
            double amps = 0.0, volts = 0.0;
            for (std::size_t i = at; i < at + length; ++i) {
                amps += segment.values[0][i] / static_cast<double>(length);
                volts += segment.values[1][i] / static_cast<double>(length);
            }
            if (std::abs(amps) < kLeastCurrent * most_a)
                continue;
            const double speed = (segment.turned_deg[at + length] - segment.turned_deg[at])
                * std::numbers::pi / 180.0 / (static_cast<double>(length) * segment.step_s);
            slowest = std::min(slowest, std::abs(speed));
            fastest = std::max(fastest, std::abs(speed));
            rows.cluster.push_back(rows.known.size() / kCluster);
            rows.known.push_back({amps, amps < 0.0 ? -1.0 : 1.0, speed});
            rows.wanted.push_back(volts);
        }
    }
    if (!(slowest < (1.0 - kLeastRange) * fastest))
        return std::nullopt;
    const auto fit = leastSquares(rows, std::array{kCurrent, kConstant, kSpeed});
    if (!fit || !(fit->values[kSpeed] > 0.0))
        return std::nullopt;
    return fit->estimate(kSpeed);
}

} // namespace lab
