#include "lab/evaluation/turning_slices.h"

#include "lab/maths/least_squares.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace lab {

namespace {

constexpr double kWindow_s = 50e-3;
constexpr double kRadians = std::numbers::pi / 180.0;

/// Of a sample at an edge: currents go in straight lines from sample to sample.
constexpr double kHalf = 0.5;

TurningSlice sliceOf(const Segment &segment, std::size_t from, std::size_t to)
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
        const double share = (at == from || at == to ? kHalf : 1.0) / many;
        const double early = 2.0 * static_cast<double>(to - at) / many * share;
        slice.q_a += share * q[at];
        slice.d_a += share * d[at];
        slice.earlyQ_a += early * q[at];
        slice.earlyD_a += early * d[at];
        if (at < to)
            slice.q_v += segment.values[2][at] / many; // voltages are held until the next one
    }
    return slice;
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

/// A stretch as columns: what accelerates, integrated once (the mean of each slice) and twice (where it begins), and
/// what the angle stands aside.
constexpr std::size_t kAccelerations = 7, kColumns = kAccelerations + 2;
struct Stretch {
    std::span<TurningSlice> slices;
    std::array<std::vector<double>, kAccelerations> speeds;
    std::array<std::vector<double>, kColumns> angles;
};

Stretch stretchOf(std::span<TurningSlice> slices, double step_s)
{
    using Of = double (*)(double q_a, double d_a, double speed);
    constexpr std::array<Of, kAccelerations> kOf{
        [](double q, double, double) { return q; },
        [](double, double, double) { return 1.0; },
        [](double, double, double w) { return w; },
        [](double, double, double w) { return w * std::abs(w); },
        [](double, double d, double) { return d; },
        [](double q, double d, double) { return q * d; },
        [](double, double d, double) { return d * d; },
    };
    Stretch stretch{slices, {}, {}};
    for (std::size_t i = 0; i < kAccelerations; ++i) {
        double speed = 0.0, angle = 0.0;
        for (const TurningSlice &slice : slices) {
            // A current that jumps late in a slice has moved the rotor less than one that was there from its beginning.
            const double mean =
                speed + kOf[i](slice.earlyQ_a, slice.earlyD_a, slice.speed) * step_s / 2.0;
            stretch.speeds[i].push_back(mean);
            stretch.angles[i].push_back(angle);
            speed += kOf[i](slice.q_a, slice.d_a, slice.speed) * step_s;
            angle += mean * step_s;
        }
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
        TurningSlice &slice = stretch.slices[at];
        slice.rotorSpeed = steady;
        for (std::size_t i = 0; i < kAccelerations; ++i)
            slice.rotorSpeed += fit.values[i] * stretch.speeds[i][at];
        for (std::size_t i = kAccelerations; i < kColumns; ++i)
            left[at] += fit.values[i] * stretch.angles[i][at];
    }
    left.push_back(left.back());
    for (std::size_t at = 0; at < stretch.slices.size(); ++at)
        stretch.slices[at].aside_rad = (left[at] + left[at + 1]) / 2.0;
}

} // namespace

double TurningSlices::lossAlongQ(std::size_t slice, double swing_a) const
{
    const auto first = phases.begin() + static_cast<std::ptrdiff_t>(slice * length);
    const auto last = first + static_cast<std::ptrdiff_t>(length);
    double sum = kHalf * (first->lossAlongQ(swing_a) + last->lossAlongQ(swing_a));
    for (auto at = first + 1; at != last; ++at)
        sum += at->lossAlongQ(swing_a);
    return sum / static_cast<double>(length);
}

TurningSlices slicesOf(const Segment &segment, double slice_s)
{
    TurningSlices slices;
    const auto length = static_cast<std::size_t>(std::lround(slice_s / segment.step_s));
    slices.step_s = static_cast<double>(length) * segment.step_s;
    slices.period_s = segment.period_s;
    slices.length = length;
    std::size_t at = 0;
    for (; length > 1 && at + length < segment.turned_deg.size(); at += length)
        slices.all.push_back(sliceOf(segment, at, at + length));
    for (std::size_t i = 0; i <= at && !slices.all.empty(); ++i)
        slices.phases.emplace_back(
            segment.angle_rad(i), segment.values[0][i], segment.values[1][i]);
    return slices;
}

double rotorSpeeds(std::vector<TurningSlices> &slices)
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
        return 0.0;
    for (const auto &[stretch, step_s] : stretches)
        setSpeeds(stretch, *fit, step_s);
    constexpr std::size_t kByQ = 0, kByD = 4;
    return std::atan2(fit->values[kByD], fit->values[kByQ]);
}

} // namespace lab
