#include "lab/evaluation/flux_fit.h"

#include "lab/maths/least_squares.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lab {

namespace {

/// Means over a window.
struct FluxWindow {
    double amps = 0.0, q_v = 0.0, d_v = 0.0;
    double speed = 0.0; ///< electrical, rad/s
};

std::vector<FluxWindow> windowsOf(const Segment &segment, double window_s)
{
    std::vector<FluxWindow> windows;
    const bool complete = segment.values.size() > kFluxId;
    const auto length = static_cast<std::size_t>(std::lround(window_s / segment.step_s));
    const auto many = static_cast<double>(length);
    for (std::size_t at = 0; length > 0 && at + length < segment.turned_deg.size(); at += length) {
        FluxWindow window;
        for (std::size_t i = at; i < at + length; ++i) {
            window.amps += segment.values[kFluxIq][i] / many;
            window.q_v += segment.values[kFluxVq][i] / many;
            if (complete)
                window.d_v += segment.values[kFluxVd][i] / many;
        }
        window.speed = (segment.turned_deg[at + length] - segment.turned_deg[at]) * std::numbers::pi
            / 180.0 / (many * segment.step_s);
        windows.push_back(window);
    }
    return windows;
}

} // namespace

std::optional<FluxFit> fitFlux(std::span<const Segment> segments, double window_s)
{
    constexpr double kLeastCurrent = 0.15; // of the largest
    constexpr double kLeastRange = 0.3; // of the fastest speed
    constexpr std::size_t kSpeed = 0, kCluster = 10;
    if (segments.empty() || segments.front().values.size() <= kFluxVq)
        return std::nullopt;
    double most_a = 0.0;
    for (const Segment &segment : segments)
        for (const double amps : segment.values[kFluxIq])
            most_a = std::max(most_a, std::abs(amps));
    Rows q, d;
    double slowest = 1e9, fastest = 0.0;
    for (const Segment &segment : segments)
        for (const FluxWindow &window : windowsOf(segment, window_s)) {
            const double amps = window.amps, speed = window.speed;
            // Voltages hold for half a period longer than the angle that they are told for, or shorter: that grows as
            // speed^2.
            d.cluster.push_back(d.known.size() / kCluster);
            d.known.push_back({speed, speed * amps, speed * speed, amps});
            d.wanted.push_back(window.d_v);
            if (std::abs(amps) < kLeastCurrent * most_a)
                continue;
            slowest = std::min(slowest, std::abs(speed));
            fastest = std::max(fastest, std::abs(speed));
            q.cluster.push_back(q.known.size() / kCluster);
            q.known.push_back({speed, amps, amps < 0.0 ? -1.0 : 1.0});
            q.wanted.push_back(window.q_v);
        }
    if (!(slowest < (1.0 - kLeastRange) * fastest))
        return std::nullopt;
    const auto along = leastSquares(q, std::array<std::size_t, 3>{0, 1, 2});
    if (!along || !(along->values[kSpeed] > 0.0))
        return std::nullopt;
    FluxFit found{along->estimate(kSpeed), std::nullopt};
    if (segments.front().values.size() > kFluxId)
        if (const auto across = leastSquares(d, std::array<std::size_t, 4>{0, 1, 2, 3}))
            found.d = across->estimate(kSpeed);
    return found;
}

Aside asideOf(const Estimate &d_wb, double told_wb)
{
    constexpr double kVoltages = 0.02; // their scale
    Aside found;
    found.sine = d_wb.value / told_wb;
    if (!(std::abs(found.sine) < 1.0))
        return {}; // not the angle alone: that the voltages differ is said
    found.cosine = std::sqrt(1.0 - found.sine * found.sine);
    const double half =
        std::hypot((*d_wb.high - *d_wb.low) / 2.0 / told_wb, kVoltages * found.sine);
    found.unsure = std::abs(found.sine) * half / (found.cosine * found.cosine);
    return found;
}

void turnCurrents(std::span<Segment> segments, const Aside &aside)
{
    for (Segment &segment : segments)
        for (std::size_t at = 0; at < segment.values[kFluxIq].size(); ++at)
            segment.values[kFluxIq][at] = aside.cosine * segment.values[kFluxIq][at]
                + aside.sine * segment.values[kFluxId][at];
}

} // namespace lab
