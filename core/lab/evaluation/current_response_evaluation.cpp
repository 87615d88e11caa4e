#include "lab/evaluation/current_response_evaluation.h"

#include "lab/evaluation/segments.h"
#include "lab/happenings.h"
#include "lab/maths/cross_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace lab {

namespace {

constexpr double kCurrentTransform_s = 0.128;
constexpr std::size_t kLowestBin = 3; ///< what is slower leaks into the first ones
constexpr double kNear = 0.08; ///< of a frequency: bins this near are taken together
constexpr double kHighest = 0.4; ///< of the sample rate
constexpr double kLeastCoherence = 0.5;
constexpr double kAround = 2.0; ///< bins to either side of what is left out
constexpr int kLeastCurrentSegments = 8;
/// Standard error that is always there, of a gain: what windows leak, and what goes round by way of the speed.
constexpr double kGainError = 0.015;

/// From the first set-point until the speed is brought elsewhere.
struct Span {
    Nanos from = 0, to = 0;
    bool any = false, left = false, over = false;
    bool commanded = false; ///< by anything since the plan
    Nanos changed = std::numeric_limits<Nanos>::max(); ///< when the gains were, first
    std::string reason; ///< why it ended early

    void accept(Nanos at, const recorded::Happening &what, const Recorded<ResponsePlan> &plan)
    {
        const bool ramp = what.name == "speed ramp";
        const bool step =
            ramp && numberOf(what, "motor") == plan.motor && numberOf(what, "ms") == 0.0;
        // What the plan lends is written before the first command, and given back behind the last set-point.
        const bool lends = plan.plan.kp > 0 && !commanded;
        if (!lends && changesGains(plan.motor, what))
            changed = std::min(changed, at);
        over = what.name == kEndEntry;
        const bool leaves =
            over || ramp || what.name == "command" || what.name == "stop" || endsLink(what);
        if (step && !any)
            from = at;
        any = any || step;
        if (any && !left && leaves)
            to = at;
        left = left || (any && !step && leaves);
        commanded = commanded || leaves;
        if (over && what.field("outcome") != "complete")
            reason = what.field("reason");
    }
};

/// Frequencies that say nothing of the loop.
struct Mask {
    /// 1 of it: offsets of the currents; 2: their gains; each 6: the dead time
    double electrical_hz = 0.0;
    double spread = 0.0; ///< of these, to either side: the speed was not one
    double turn_hz = 0.0; ///< and its multiples: of the speed loop
    double bin_hz = 0.0;

    bool hides(double hz) const
    {
        const auto near = [&](double each, double share) {
            const double order = std::round(hz / each);
            return order >= 1.0
                && std::abs(hz - order * each) <= kAround * bin_hz + share * order * each;
        };
        constexpr double kDead = 6.0, kGains = 2.0;
        const bool low = hz < (kGains + 0.5) * electrical_hz && near(electrical_hz, spread);
        return low || near(kDead * electrical_hz, spread) || near(turn_hz, 0.0);
    }
};

/// All bins from one on that are as near as a band and not hidden, as one point; the next one behind them.
std::size_t addPoint(
    FrequencyResponse &found, const CrossSpectra &fine, std::size_t first, const Mask &mask)
{
    const double most = static_cast<double>(first) * (1.0 + kNear);
    double weight = 0.0, weighted = 0.0, own = 0.0;
    Complex cross;
    int bins = 0;
    std::size_t bin = first;
    for (; bin < fine.instrument.size() && static_cast<double>(bin) <= most; ++bin) {
        const double hz = static_cast<double>(bin) * fine.binHz;
        if (mask.hides(hz))
            continue;
        weight += fine.instrument[bin];
        weighted += fine.instrument[bin] * hz;
        cross += fine.cross[0][bin];
        own += fine.own[0][bin];
        ++bins;
    }
    const double both = weight * own;
    if (bins == 0 || !(both > 0.0))
        return bin;
    ResponsePoint point;
    point.hz = weighted / weight;
    point.coherence = std::min(1.0, std::norm(cross) / both);
    point.plant = cross / weight;
    point.relative =
        std::hypot(std::sqrt(varianceOf(point.coherence, bins * fine.averages)), kGainError);
    point.loop = point.plant / (1.0 - point.plant);
    point.loopRelative = point.relative / std::abs(1.0 - point.plant);
    if (point.coherence >= kLeastCoherence)
        found.points.push_back(point);
    return bin;
}

} // namespace

Result<FrequencyResponse, std::string> evaluateCurrentResponse(
    const capture::Capture &capture, const Happenings &all)
{
    const auto [plan, after] = planIn<ResponsePlan>(all);
    if (!plan || plan->plan.current == 0)
        return fail(std::string("it is no recording of a current loop's frequency response"));
    const std::array others{
        fastChannel(capture, plan->reference), fastChannel(capture, plan->current)};
    const capture::Channel *angle = fastChannel(capture, plan->angle);
    if (angle == nullptr || others[0] == nullptr || others[1] == nullptr)
        return fail(std::string("it holds no samples of the signals that it needs"));
    Span span;
    for (auto at = after.begin(); at != after.end() && !span.over; ++at)
        span.accept(at->first, at->second, *plan);
    if (!span.any)
        return fail(std::string("the set-point was never moved in it"));
    if (span.changed <= span.to)
        return fail(std::string(kGainsChanged));
    const std::vector<Segment> segments = segmentsOf(*angle, others, span.from, span.to);
    if (segments.empty())
        return fail(std::string("it holds no samples of that time"));
    const double step_s = segments.front().step_s;
    if (auto why = tooFarApart(step_s, true); !why.empty())
        return fail(std::move(why));
    const std::size_t size =
        2 * static_cast<std::size_t>(std::lround(kCurrentTransform_s / step_s / 2.0));
    CrossSpectrum sum(size, 1.0 / step_s, 1);
    double turned_deg = 0.0, time_s = 0.0, amps = 0.0, samples = 0.0;
    for (const Segment &segment : segments) {
        sum.add(segment.values);
        turned_deg += std::abs(segment.turned_deg.back());
        time_s += segment.step_s * static_cast<double>(segment.turned_deg.size());
        amps = std::accumulate(segment.values[1].begin(), segment.values[1].end(), amps);
        samples += static_cast<double>(segment.values[1].size());
    }
    if (sum.count() < kLeastCurrentSegments)
        return fail(std::string("too little of it is without a gap: a second is needed"));
    const CrossSpectra fine = sum.result();
    constexpr double kTurn_deg = 360.0;
    const Mask mask{.electrical_hz = turned_deg / kTurn_deg / time_s,
        .spread = 1.5 * plan->plan.amplitudeRpm / std::max(1, std::abs(plan->plan.rpm)),
        .turn_hz = 1.0 / plan->regulator.period_s,
        .bin_hz = fine.binHz};
    FrequencyResponse found;
    const auto end = static_cast<std::size_t>(kHighest * static_cast<double>(size));
    for (std::size_t bin = kLowestBin; bin < end;)
        bin = addPoint(found, fine, bin, mask);
    if (found.points.empty())
        return fail(std::string("the current does not follow its reference in it"));
    found.notes.push_back("it is the loop at " + decimalText(std::abs(amps) / samples, 3)
        + " A: what a bridge loses by its dead time damps it the more the smaller the current is");
    noteGaps(found.notes, missingIn(segments));
    noteEnd(found.notes, span.over, span.reason);
    constexpr double kSure = 0.8;
    addMargins(found, kSure);
    return found;
}

} // namespace lab
