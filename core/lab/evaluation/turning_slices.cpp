#include "lab/evaluation/turning_slices.h"

#include "lab/maths/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace lab {

namespace {

constexpr double kSlice_s = 1e-3, kWindow_s = 50e-3;
constexpr double kRadians = std::numbers::pi / 180.0;

/// How far the dead time's loss lies along q, for each volt of a phase: each phase loses against its own current.
double lossAlongQ(double angle_rad, double q_a, double d_a, double small_a)
{
    const double cosine = std::cos(angle_rad), sine = std::sin(angle_rad);
    const double alpha = q_a * cosine + d_a * sine;
    const double beta = std::numbers::sqrt3 * (d_a * cosine - q_a * sine);
    const auto sign = [small_a](double amps) { return std::clamp(amps / small_a, -1.0, 1.0); };
    const double a = sign(alpha), b = sign(-(alpha + beta) / 2.0), c = sign(-(alpha - beta) / 2.0);
    return (2.0 * a - b - c) / 3.0 * cosine - (c - b) / std::numbers::sqrt3 * sine;
}

TurningSlice sliceOf(const Segment &segment, std::size_t from, std::size_t to, double small_a)
{
    const std::vector<double> &q = segment.values[0], &d = segment.values[1];
    const auto many = static_cast<double>(to - from);
    const double time_s = many * segment.step_s;
    TurningSlice slice;
    slice.angle_rad = segment.turned_deg[from] * kRadians;
    slice.speed = (segment.turned_deg[to] - segment.turned_deg[from]) * kRadians / time_s;
    slice.rotorSpeed = slice.speed;
    slice.dq = (q[to] - q[from]) / time_s;
    for (std::size_t at = from; at <= to; ++at) {
        constexpr double kHalf = 0.5; // currents go in straight lines from sample to sample
        const double share = (at == from || at == to ? kHalf : 1.0) / many;
        slice.q_a += share * q[at];
        slice.d_a += share * d[at];
        slice.lossQ += share
            * lossAlongQ(
                (segment.first_deg + segment.turned_deg[at]) * kRadians, q[at], d[at], small_a);
        if (at < to)
            slice.q_v += segment.values[2][at] / many; // voltages are held until the next one
    }
    return slice;
}

/// The integral of a signal from the beginning of the first slice to that of each, and to the end of the last.
std::vector<double> integral(std::span<const double> means, double step_s)
{
    std::vector<double> sums{0.0};
    for (const double mean : means)
        sums.push_back(sums.back() + mean * step_s);
    return sums;
}

std::vector<double> integralOfStraight(std::span<const double> edges, double step_s)
{
    std::vector<double> sums{0.0};
    for (std::size_t i = 1; i < edges.size(); ++i)
        sums.push_back(sums.back() + (edges[i - 1] + edges[i]) / 2.0 * step_s);
    return sums;
}

/// Takes the straight line out that fits best. @return  its slope, per step
double straighten(std::span<double> values)
{
    const auto n = static_cast<double>(values.size());
    const double middle = (n - 1.0) / 2.0;
    double mean = 0.0, slope = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double x = static_cast<double>(i) - middle;
        mean += values[i] / n;
        slope += values[i] * x;
        squares += x * x;
    }
    slope /= squares;
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] -= mean + slope * (static_cast<double>(i) - middle);
    return slope;
}

/// A stretch as columns: what accelerates, integrated once and twice, and what the angle stands aside.
constexpr std::size_t kAccelerations = 7, kColumns = kAccelerations + 2;
struct Stretch {
    std::span<TurningSlice> slices;
    std::array<std::vector<double>, kAccelerations> speeds;
    std::array<std::vector<double>, kColumns> angles;
};

Stretch stretchOf(std::span<TurningSlice> slices, double step_s)
{
    using Of = double (*)(const TurningSlice &);
    constexpr std::array<Of, kAccelerations> kOf{
        [](const TurningSlice &w) { return w.q_a; },
        [](const TurningSlice &) { return 1.0; },
        [](const TurningSlice &w) { return w.speed; },
        [](const TurningSlice &w) { return w.speed * std::abs(w.speed); },
        [](const TurningSlice &w) { return w.d_a; },
        [](const TurningSlice &w) { return w.q_a * w.d_a; },
        [](const TurningSlice &w) { return w.d_a * w.d_a; },
    };
    Stretch stretch{slices, {}, {}};
    for (std::size_t i = 0; i < kAccelerations; ++i) {
        std::vector<double> means;
        for (const TurningSlice &slice : slices)
            means.push_back(kOf[i](slice));
        stretch.speeds[i] = integral(means, step_s);
        stretch.angles[i] = integralOfStraight(stretch.speeds[i], step_s);
        stretch.angles[i].pop_back();
    }
    for (std::size_t at = 0; at < slices.size(); ++at) {
        const TurningSlice &now = slices[at], &before = slices[at == 0 ? 0 : at - 1];
        stretch.angles[kAccelerations].push_back((now.q_a + before.q_a) / 2.0);
        stretch.angles[kAccelerations + 1].push_back((now.d_a + before.d_a) / 2.0);
    }
    return stretch;
}

void addRows(Rows &rows, Stretch stretch, std::size_t cluster)
{
    std::vector<double> angles;
    for (const TurningSlice &slice : stretch.slices)
        angles.push_back(slice.angle_rad);
    straighten(angles);
    for (std::vector<double> &column : stretch.angles)
        straighten(column);
    for (std::size_t at = 0; at < angles.size(); ++at) {
        Row row{};
        for (std::size_t i = 0; i < kColumns; ++i)
            row[i] = stretch.angles[i][at];
        rows.known.push_back(row);
        rows.wanted.push_back(angles[at]);
        rows.cluster.push_back(cluster);
    }
}

void setSpeeds(const Stretch &stretch, const Fit &fit, double step_s)
{
    std::vector<double> left;
    for (std::size_t at = 0; at < stretch.slices.size(); ++at) {
        left.push_back(stretch.slices[at].angle_rad);
        for (std::size_t i = 0; i < kColumns; ++i)
            left.back() -= fit.values[i] * stretch.angles[i][at];
    }
    const double steady = straighten(left) / step_s;
    for (std::size_t at = 0; at < stretch.slices.size(); ++at) {
        stretch.slices[at].rotorSpeed = steady;
        for (std::size_t i = 0; i < kAccelerations; ++i)
            stretch.slices[at].rotorSpeed +=
                fit.values[i] * (stretch.speeds[i][at] + stretch.speeds[i][at + 1]) / 2.0;
    }
}

} // namespace

TurningSlices slicesOf(const Segment &segment, double small_a)
{
    TurningSlices slices;
    const auto length = static_cast<std::size_t>(std::lround(kSlice_s / segment.step_s));
    slices.step_s = static_cast<double>(length) * segment.step_s;
    for (std::size_t at = 0; length > 1 && at + length < segment.turned_deg.size(); at += length)
        slices.all.push_back(sliceOf(segment, at, at + length, small_a));
    return slices;
}

void rotorSpeeds(std::vector<TurningSlices> &slices)
{
    std::vector<std::pair<Stretch, double>> stretches;
    Rows rows;
    for (TurningSlices &one : slices) {
        const auto length = static_cast<std::size_t>(std::lround(kWindow_s / one.step_s));
        for (std::size_t at = 0; at + length <= one.all.size(); at += length) {
            stretches.emplace_back(
                stretchOf(std::span(one.all).subspan(at, length), one.step_s), one.step_s);
            addRows(rows, stretches.back().first, stretches.size() - 1);
        }
    }
    constexpr std::array<std::size_t, kColumns> kAll{0, 1, 2, 3, 4, 5, 6, 7, 8};
    const auto fit = leastSquares(rows, kAll);
    if (!fit)
        return;
    for (const auto &[stretch, step_s] : stretches)
        setSpeeds(stretch, *fit, step_s);
}

} // namespace lab
