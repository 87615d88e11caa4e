#include "lab/evaluation/turning_fit.h"

#include "lab/maths/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace lab {

namespace {

enum Unknown : std::size_t { kRs, kLoss, kAlongD, kAlongQ, kMagnets, kAside };

/// From which change on a current jumps: 0.6 of what thirty exceed, or as far as noise does not go. Smaller ones move
/// with what the angle is off by.
double leastJump(const std::vector<TurningSlices> &slices)
{
    constexpr double kFar = 3.0, kDeviation = 1.4826; // of a normal distribution, from its median
    constexpr std::size_t kFew = 30;
    constexpr double kShare = 0.6;
    std::vector<double> changes;
    for (const TurningSlices &one : slices)
        for (const TurningSlice &slice : one.all)
            changes.push_back(std::abs(slice.dq));
    if (changes.size() <= kFew)
        return 0.0;
    const auto inOrder = [&](std::size_t place) {
        const auto at = changes.begin() + static_cast<std::ptrdiff_t>(place);
        std::nth_element(changes.begin(), at, changes.end());
        return *at;
    };
    const double noise = kFar * kDeviation * inOrder(changes.size() / 2);
    const double jump = inOrder(changes.size() - kFew);
    return std::clamp(noise, kShare * jump, jump);
}

/// One row for each slice, or every so many-th, but for what the dead time takes.
/// @param least  Lq is told by jumps alone, changes of so much: they are its instrument. 0: by all
Rows rowsOf(const std::vector<TurningSlices> &slices, double least, std::size_t every)
{
    Rows rows;
    std::size_t cluster = 0;
    for (const TurningSlices &one : slices) {
        constexpr double kCluster_s = 0.1; // what disturbs one slice disturbs the next
        const auto length = static_cast<std::size_t>(std::lround(kCluster_s / one.step_s));
        for (std::size_t at = 0; at < one.all.size(); at += every) {
            const TurningSlice &w = one.all[at];
            cluster += at % length < every ? 1 : 0;
            rows.known.push_back({w.q_a, 0.0, w.speed * w.d_a, w.dq,
                w.rotorSpeed * std::cos(w.aside_rad), w.rotorSpeed * w.aside_rad});
            rows.instruments.push_back(rows.known.back());
            if (std::abs(w.dq) < least)
                rows.instruments.back()[kAlongQ] = 0.0;
            rows.wanted.push_back(w.q_v);
            rows.cluster.push_back(cluster);
        }
    }
    return rows;
}

void setSwing(
    Rows &rows, const std::vector<TurningSlices> &slices, std::size_t every, double swing_a)
{
    std::size_t row = 0;
    for (const TurningSlices &one : slices)
        for (std::size_t at = 0; at < one.all.size(); at += every, ++row)
            rows.known[row][kLoss] = rows.instruments[row][kLoss] = one.lossAlongQ(at, swing_a);
}

/// Rows take a current for a straight line from sample to sample, where it goes to its end as e^(-R t / L). Of an
/// inductance L they find R T / 2 / tanh(R T / (2 L)). @return  L
double bent(double found, double rs_ohm, double period_s)
{
    const double half = rs_ohm * period_s / 2.0;
    return half > 0.0 && found > half ? half / std::atanh(half / found) : found;
}

Estimate bent(const Estimate &found, double rs_ohm, double period_s)
{
    // Of the difference: how much of a dead time acts as a resistance.
    constexpr double kUnsure = 1.0 / 3.0;
    const double value = bent(found.value, rs_ohm, period_s);
    const double share = value / found.value, unsure = kUnsure * (found.value - value);
    return {value, *found.low * share - unsure, *found.high * share + unsure};
}

/// What the dead time adds to the resistance within a control period: it acts as one in the phases that swing through
/// zero. Of each slice as much as it tells of Ld. Where those swing so far that the currents at rest do, too, the
/// resistance holds it already.
double ohmBySwing(const std::vector<TurningSlices> &slices, const Bridge &bridge, double swing_a,
    const Estimate &lost_v)
{
    constexpr double kAtRest = 1.0 / 3.0; // of the nominal current; half of it is the most at rest
    if (swing_a > kAtRest * bridge.nominal_a || !(*lost_v.low > 0.0))
        return 0.0;
    double swinging = 0.0, all = 0.0;
    for (const TurningSlices &one : slices)
        for (std::size_t at = 0; at < one.all.size(); ++at) {
            const double weight = one.all[at].d_a * one.all[at].d_a;
            swinging += weight * one.phases[at * one.length].swinging(swing_a);
            all += weight;
        }
    return swinging > 0.0 ? lost_v.value / swing_a * swinging / all : 0.0;
}

/// Where every current swings through zero, resistance and loss are one.
std::optional<Fit> fitOf(const Rows &rows, bool aside)
{
    constexpr std::array<std::size_t, 6> kAll{kLoss, kRs, kAlongD, kAlongQ, kMagnets, kAside};
    const auto unknowns = std::span(kAll).first(aside ? kAll.size() : kAll.size() - 1);
    const auto fit = leastSquares(rows, unknowns);
    return fit ? fit : leastSquares(rows, unknowns.subspan(1));
}

struct BestFit {
    Fit fit;
    Row changes{}; ///< to either side, beside what the rows leave open; see unknownOf()
    double swing_a = 0.0;
};

/// How far a phase's current swings within a PWM period follows from the inductance, bus T / (16 L), which in turn
/// depends on what the dead time takes: swings are tried, shares of the nominal current, and those that fit the
/// inductance count. The loops may run once in several PWM periods.
std::optional<BestFit> bestFit(const std::vector<TurningSlices> &slices, const Bridge &bridge,
    std::optional<double> rs_ohm, bool allTellLq)
{
    constexpr double kFirstShare = 0.005, kLastShare = 1.5, kNext = 1.25;
    constexpr double kMostPeriods = 4.0, kFits = 1.3;
    constexpr std::size_t kSome = 4; // slices tell the swing as well as all
    const double period_s = slices.front().period_s;
    const auto swingOf = [&](const Fit &fit) {
        const double ohm = rs_ohm.value_or(fit.values[kRs]);
        return bridge.bus_v * period_s / (16.0 * bent(fit.values[kAlongD], ohm, period_s));
    };
    Rows rows = rowsOf(slices, 0.0, kSome);
    const bool aside = std::any_of(
        rows.known.begin(), rows.known.end(), [](const Row &row) { return row[kAside] != 0.0; });
    std::optional<Fit> best;
    double periods = 1.0;
    for (double share = kFirstShare; share < kLastShare; share *= kNext) {
        const double swing_a = share * bridge.nominal_a;
        setSwing(rows, slices, kSome, swing_a);
        const auto fit = fitOf(rows, aside);
        if (!fit || !(fit->values[kAlongD] > 0.0) || (best && best->residual <= fit->residual))
            continue;
        const double many = swingOf(*fit) / swing_a;
        if (many < 1.0 / kFits || many > kMostPeriods * kFits)
            continue;
        best = fit;
        periods = std::clamp(std::round(many), 1.0, kMostPeriods);
    }
    rows = rowsOf(slices, allTellLq ? 0.0 : leastJump(slices), 1);
    double swing_a = 0.0;
    for (int round = 0; round < 2 && best && best->values[kAlongD] > 0.0; ++round) {
        swing_a = swingOf(*best) / periods;
        setSwing(rows, slices, 1, swing_a);
        best = fitOf(rows, aside);
    }
    if (!best)
        return std::nullopt;
    BestFit found{*best, {}, swing_a};
    if (const auto straight = fitOf(rows, false))
        for (std::size_t i = 0; i < kAside; ++i)
            found.changes[i] = std::abs(best->values[i] - straight->values[i]);
    const auto [least, most] = std::minmax_element(rows.known.begin(), rows.known.end(),
        [](const Row &a, const Row &b) { return a[kAlongD] < b[kAlongD]; });
    const double range = ((*most)[kAlongD] - (*least)[kAlongD]) / 2.0;
    found.changes[kAlongD] = std::hypot(found.changes[kAlongD], best->residual / range);
    return found;
}

/// The change by the coordinates that stand aside is in its interval: they are known from currents and angle alone. So
/// is, in that of Ld, which slow turns tell badly, that what the fit leaves might go with the current along the
/// magnets.
Estimate unknownOf(const BestFit &found, std::size_t unknown)
{
    const Estimate own = found.fit.estimate(unknown);
    const double half = std::hypot((*own.high - *own.low) / 2.0, found.changes[unknown]);
    return {own.value, own.value - half, own.value + half};
}

} // namespace

std::optional<TurningFit> turningFit(const std::vector<TurningSlices> &slices, const Bridge &bridge,
    std::optional<double> rs_ohm, bool allTellLq)
{
    if (slices.empty())
        return std::nullopt;
    const auto best = bestFit(slices, bridge, rs_ohm, allTellLq);
    if (!best)
        return std::nullopt;
    const Row &values = best->fit.values;
    if (!(values[kAlongD] > 0.0) || !(values[kMagnets] > 0.0))
        return std::nullopt;
    const Estimate lost_v = best->fit.estimate(kLoss);
    const double ohm =
        rs_ohm.value_or(values[kRs]) + ohmBySwing(slices, bridge, best->swing_a, lost_v);
    const double period_s = slices.front().period_s;
    TurningFit found{.ld_h = bent(unknownOf(*best, kAlongD), ohm, period_s),
        .flux_wb = unknownOf(*best, kMagnets),
        .lq_h = {},
        .swing_a = best->swing_a,
        .lost_v = lost_v};
    if (values[kAlongQ] > 0.0)
        found.lq_h = bent(unknownOf(*best, kAlongQ), ohm, period_s);
    return found;
}

} // namespace lab
