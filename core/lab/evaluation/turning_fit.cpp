#include "lab/evaluation/turning_fit.h"

#include "lab/maths/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace lab {

namespace {

enum Unknown : std::size_t { kRs, kLoss, kAlongD, kAlongQ, kMagnets, kAside, kAsideTwice };

/// From which change on a current jumps; 0: too few do. Smaller ones are noise, and what the angle is off by moves with them.
double leastJump(const std::vector<TurningSlices> &slices)
{
    constexpr double kFar = 3.0, kDeviation = 1.4826; // of a normal distribution, from its median
    std::vector<double> changes;
    for (const TurningSlices &one : slices)
        for (const TurningSlice &slice : one.all)
            changes.push_back(std::abs(slice.dq));
    const auto middle = changes.begin() + static_cast<std::ptrdiff_t>(changes.size() / 2);
    std::nth_element(changes.begin(), middle, changes.end());
    const double least = kFar * kDeviation * *middle;
    constexpr std::ptrdiff_t kFew = 20;
    const auto jumps = std::count_if(
        changes.begin(), changes.end(), [least](double change) { return change >= least; });
    return jumps < kFew ? 0.0 : least;
}

/// One row for each slice, or every so many-th, but for what the dead time takes. Lq is told by the jumps alone: they are its instrument.
Rows rowsOf(const std::vector<TurningSlices> &slices, bool angleJumps, std::size_t every)
{
    Rows rows;
    const double least = angleJumps ? 0.0 : leastJump(slices);
    std::size_t cluster = 0;
    for (const TurningSlices &one : slices) {
        constexpr double kCluster_s = 0.1; // what disturbs one slice disturbs the next
        const auto length = static_cast<std::size_t>(std::lround(kCluster_s / one.step_s));
        for (std::size_t at = 0; at < one.all.size(); at += every) {
            const TurningSlice &w = one.all[at];
            const double aside = w.rotorSpeed * w.aside_rad;
            cluster += at % length < every ? 1 : 0;
            rows.known.push_back(
                {w.q_a, 0.0, w.speed * w.d_a, w.dq, w.rotorSpeed, aside, aside * w.aside_rad});
            rows.instruments.push_back(rows.known.back());
            if (std::abs(w.dq) < least)
                rows.instruments.back()[kAlongQ] = 0.0;
            rows.wanted.push_back(w.q_v);
            rows.cluster.push_back(cluster);
        }
    }
    return rows;
}

/// How far a phase's current swings within a PWM period is not known, so that it is tried: shares of the nominal current.
constexpr std::size_t kSwings = 25;
double swingShare(std::size_t swing)
{
    constexpr double kLeast = 0.005, kNext = 1.25;
    return kLeast * std::pow(kNext, static_cast<double>(swing));
}

void setSwing(
    Rows &rows, const std::vector<TurningSlices> &slices, std::size_t every, double swing_a)
{
    std::size_t row = 0;
    for (const TurningSlices &one : slices)
        for (std::size_t at = 0; at < one.all.size(); at += every, ++row)
            rows.known[row][kLoss] = rows.instruments[row][kLoss] = one.lossAlongQ(at, swing_a);
}

struct BestFit {
    Fit fit;
    Row changes{}; ///< by what the unknowns change with it that the coordinates stand aside
    double swing_a = 0.0;
};

/// Of the swings that are tried the one that leaves least: what is left falls towards it and rises behind it.
template <class Left>
std::size_t leastSwing(Left left)
{
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    const auto attempt = [&](std::size_t swing) {
        if (const double now = left(swing); now < least) {
            least = now;
            best = swing;
        }
    };
    constexpr std::size_t kFirst = 6;
    for (std::size_t swing = 0; swing < kSwings; swing += kFirst)
        attempt(swing);
    for (const std::size_t stride : {3, 2, 1}) {
        const std::size_t middle = best;
        if (middle >= stride)
            attempt(middle - stride);
        if (middle + stride < kSwings)
            attempt(middle + stride);
    }
    return best;
}

std::optional<BestFit> bestFit(
    const std::vector<TurningSlices> &slices, double nominal_a, bool angleJumps)
{
    constexpr std::array<std::size_t, 7> kAll{
        kRs, kLoss, kAlongD, kAlongQ, kMagnets, kAside, kAsideTwice};
    constexpr std::size_t kSome = 4; // slices tell the swing as well as all
    Rows some = rowsOf(slices, angleJumps, kSome);
    const bool aside = std::any_of(
        some.known.begin(), some.known.end(), [](const Row &row) { return row[kAside] != 0.0; });
    const std::span unknowns(kAll.data(), aside ? kAll.size() : std::size_t{kAside});
    BestFit found;
    found.swing_a = nominal_a * swingShare(leastSwing([&](std::size_t swing) {
        setSwing(some, slices, kSome, swingShare(swing) * nominal_a);
        const auto fit = leastSquares(some, unknowns);
        return fit ? fit->residual : std::numeric_limits<double>::infinity();
    }));
    Rows rows = rowsOf(slices, angleJumps, 1);
    setSwing(rows, slices, 1, found.swing_a);
    const auto fit = leastSquares(rows, unknowns);
    if (!fit)
        return std::nullopt;
    found.fit = *fit;
    if (const auto straight = leastSquares(rows, unknowns.first(kAside)))
        for (std::size_t i = 0; i < kAside; ++i)
            found.changes[i] = std::abs(fit->values[i] - straight->values[i]);
    return found;
}

/// The change by the coordinates that stand aside is in its interval: they are known from currents and angle alone.
Estimate unknownOf(const BestFit &found, std::size_t unknown)
{
    const Estimate own = found.fit.estimate(unknown);
    const double half = std::hypot((*own.high - *own.low) / 2.0, found.changes[unknown]);
    return {own.value, own.value - half, own.value + half};
}

/// Rows take a current for a straight line from sample to sample, where it goes to its end as e^(-R t / L). Of an inductance L
/// they find R T / 2 / tanh(R T / (2 L)).
Estimate bent(const Estimate &found, double rs_ohm, double period_s)
{
    constexpr double kUnsure =
        1.0 / 3.0; // of the difference: within its swing a dead time acts as a resistance, too
    const double half = rs_ohm * period_s / 2.0;
    if (!(half > 0.0) || !(found.value > half))
        return found;
    const double value = half / std::atanh(half / found.value);
    const double share = value / found.value, unsure = kUnsure * (found.value - value);
    return {value, *found.low * share - unsure, *found.high * share + unsure};
}

} // namespace

std::optional<TurningFit> turningFit(const std::vector<TurningSlices> &slices, double nominal_a,
    std::optional<double> rs_ohm, bool angleJumps)
{
    if (slices.empty())
        return std::nullopt;
    const auto best = bestFit(slices, nominal_a, angleJumps);
    if (!best)
        return std::nullopt;
    const Row &values = best->fit.values;
    if (!(values[kAlongD] > 0.0) || !(values[kAlongQ] > 0.0) || !(values[kMagnets] > 0.0))
        return std::nullopt;
    const double ohm = rs_ohm.value_or(values[kRs]), period_s = slices.front().period_s;
    return TurningFit{bent(unknownOf(*best, kAlongD), ohm, period_s),
        bent(unknownOf(*best, kAlongQ), ohm, period_s), unknownOf(*best, kMagnets), best->swing_a,
        best->fit.estimate(kLoss)};
}

} // namespace lab
