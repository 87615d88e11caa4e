#include "lab/mechanical_evaluation.h"

#include "lab/fields.h"
#include "lab/least_squares.h"
#include "scope/sample_range.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lab {

namespace {

constexpr double kStretch_s = 0.5; ///< in which all is integrated from its beginning
constexpr double kRow_s = 10e-3;
constexpr double kEdge_s = 5e-3; ///< to either side of an instant, for its speed
constexpr std::size_t kInertia = 0, kViscous = 1, kDry = 2, kFan = 3, kTilt = 4, kUnknowns = 5;
constexpr std::size_t kLeastStretches = 8;

/// When the motor was driven by torques: from the first one to whatever came then.
struct Span {
    Nanos from = 0, to = 0;
    std::string reason; ///< why it ended early; empty: it did not, or nothing says so
    bool complete = false;
};

std::optional<Span> spanOf(const RecordedSpin &plan, Happenings::const_iterator at,
    Happenings::const_iterator end, Nanos last)
{
    std::optional<Span> span;
    for (; at != end; ++at) {
        const auto &[time, what] = *at;
        if (what.name == "torque ramp" && numberOf(what, "motor") == plan.motor) {
            if (!span)
                span = Span{time, last, {}, false};
        } else if (what.name == "speed ramp" || what.name == "command" || what.name == "stop"
            || what.name == "link") {
            if (span)
                span->to = std::min(span->to, time);
        } else if (what.name == kEndEntry) {
            if (span) {
                span->to = std::min(span->to, time);
                span->complete = fieldOf(what, "outcome") == "complete";
                span->reason = span->complete ? std::string() : fieldOf(what, "reason");
            }
            break;
        }
    }
    return span;
}

/// The rows of all stretches without a gap.
class Stretches {
public:
    Stretches(
        const RecordedSpin &plan, const capture::Channel &angle, const capture::Channel &current)
        : m_plan(plan)
        , m_angle(angle)
        , m_current(current)
    {
    }
    void take(Nanos from, Nanos to)
    {
        // Signals of one stream have their samples at the same times.
        const scope::SampleRange turns(m_angle, from, to), amps(m_current, from, to);
        if (turns.end() - turns.begin() != amps.end() - amps.begin() || turns.empty())
            return;
        std::vector<double> values;
        amps.visit([&](double, double value, bool) { values.push_back(value); });
        constexpr double kTurn_deg = 360.0;
        std::vector<double> angle; // mechanical, rad
        std::vector<double> current;
        double before = 0.0, first_s = 0.0, last_s = 0.0;
        std::size_t at = 0;
        const auto flush = [&] {
            if (angle.size() > 2)
                cut(angle, current, (last_s - first_s) / static_cast<double>(angle.size() - 1));
            angle.clear();
            current.clear();
        };
        turns.visit([&](double seconds, double value, bool joined) {
            if (!joined)
                flush();
            if (angle.empty())
                first_s = seconds;
            const double step = std::remainder(value - before, kTurn_deg) / kTurn_deg * 2.0
                * std::numbers::pi / m_plan.polePairs;
            angle.push_back(angle.empty() ? 0.0 : angle.back() + step);
            current.push_back(values[at++]);
            before = value;
            last_s = seconds;
        });
        flush();
    }
    Rows rows;
    std::size_t count = 0;
    double fastest = 0.0; ///< rad/s

private:
    void cut(const std::vector<double> &angle, const std::vector<double> &current, double step_s)
    {
        const auto length = static_cast<std::size_t>(std::lround(kStretch_s / step_s));
        const auto edge = static_cast<std::size_t>(std::max(1L, std::lround(kEdge_s / step_s)));
        for (std::size_t at = edge; at + length + edge < angle.size(); at += length)
            stretch(angle, current, at, at + length, edge, step_s);
    }

    /// Integrals from its beginning, less their means: what they were before it is not known, and need not be.
    void stretch(const std::vector<double> &angle, const std::vector<double> &current,
        std::size_t from, std::size_t to, std::size_t edge, double step_s)
    {
        const auto speed = [&](std::size_t at) {
            return (angle[at + edge] - angle[at - edge])
                / (2.0 * static_cast<double>(edge) * step_s);
        };
        const auto every = static_cast<std::size_t>(std::max(1L, std::lround(kRow_s / step_s)));
        const double sign = angle[to] < angle[from] ? -1.0 : 1.0;
        const std::size_t first = rows.known.size();
        double impulse = 0.0, cubes = 0.0, squares = 0.0, before = speed(from);
        Row sum{};
        double sumWanted = 0.0;
        for (std::size_t at = from, row = from; at < to; ++at) {
            if (at == row) {
                const double now = speed(at);
                if (at > from) // Simpson's rule would gain nothing on so short a time
                    squares += (now * std::abs(now) + before * std::abs(before)) / 2.0
                        * static_cast<double>(every) * step_s;
                before = now;
                fastest = std::max(fastest, std::abs(now));
                rows.known.push_back({now, angle[at] - angle[from],
                    sign * static_cast<double>(at - from) * step_s, squares, cubes});
                rows.wanted.push_back(m_plan.torquePerAmp * impulse);
                rows.cluster.push_back(count);
                for (std::size_t i = 0; i < kMostUnknowns; ++i)
                    sum[i] += rows.known.back()[i];
                sumWanted += rows.wanted.back();
                row += every;
            }
            const double amps = (current[at] + current[at + 1]) / 2.0;
            impulse += amps * step_s;
            cubes += amps * amps * amps * step_s;
        }
        const auto many = static_cast<double>(rows.known.size() - first);
        for (std::size_t row = first; row < rows.known.size(); ++row) {
            for (std::size_t i = 0; i < kMostUnknowns; ++i)
                rows.known[row][i] -= sum[i] / many;
            rows.wanted[row] -= sumWanted / many;
        }
        ++count;
    }

    const RecordedSpin &m_plan;
    const capture::Channel &m_angle;
    const capture::Channel &m_current;
};

/// What cannot be below 0 is left out where it would be.
std::optional<Fit> fitOf(const Rows &rows, std::vector<std::size_t> columns)
{
    auto fit = leastSquares(rows, columns);
    for (const std::size_t column : {kViscous, kDry}) {
        if (!fit || fit->values[column] >= 0.0)
            continue;
        std::erase(columns, column);
        fit = leastSquares(rows, columns);
    }
    return fit;
}

} // namespace

Result<Mechanics, std::string> evaluateMechanics(
    const capture::Capture &capture, const Happenings &happenings)
{
    std::optional<RecordedSpin> plan;
    auto at = happenings.begin();
    for (; at != happenings.end() && !plan; ++at)
        plan = recordedSpin(at->second);
    if (!plan)
        return fail(std::string("it is no recording of a mechanical identification"));
    const capture::Channel *angle = fastChannel(capture, plan->angle);
    const capture::Channel *current = fastChannel(capture, plan->current);
    if (angle == nullptr || current == nullptr || angle->empty())
        return fail(std::string("it holds no samples of the signals that it needs"));
    const auto span = spanOf(*plan, at, happenings.end(), angle->timeOf(angle->end() - 1));
    if (!span)
        return fail(std::string("the motor was never driven by a torque in it"));
    Stretches stretches(*plan, *angle, *current);
    stretches.take(span->from, span->to);
    const Rows &rows = stretches.rows;
    if (stretches.count < kLeastStretches)
        return fail("it holds only " + std::to_string(stretches.count)
            + " stretches of 0.5 s without a gap; " + std::to_string(kLeastStretches)
            + " are needed");
    const auto plain = fitOf(rows, {kInertia, kViscous, kDry, kTilt});
    const auto fan = fitOf(rows, {kInertia, kViscous, kDry, kFan, kTilt});
    if (!plain || !fan || !(plain->values[kInertia] > 0.0))
        return fail(std::string("the speed hardly changed: no inertia follows from it"));
    Mechanics found;
    // A friction below 0 in the plain model: something grows faster than the speed. A fan that takes next to nothing is none.
    const bool impossible = plain->unknowns < kUnknowns - 1;
    constexpr double kNoticeable = 0.05;
    const double fastest = stretches.fastest;
    const double friction = fan->values[kViscous] * fastest + fan->values[kDry];
    found.fan = fan->estimate(kFan).low > 0.0
        && fan->values[kFan] * fastest * fastest > kNoticeable * friction
        && (impossible || fan->criterion() < plain->criterion());
    const Fit &chosen = found.fan ? *fan : *plain;
    found.inertia_kgm2 = chosen.estimate(kInertia);
    found.viscous_nms = chosen.estimate(kViscous);
    found.dry_nm = chosen.estimate(kDry);
    found.fan_nms2 = found.fan ? fan->estimate(kFan)
                               : Estimate{0.0, 0.0, std::max(0.0, *fan->estimate(kFan).high)};
    double squares = 0.0;
    for (const double torque : rows.wanted)
        squares += torque * torque;
    found.share = chosen.residual / std::sqrt(squares / static_cast<double>(rows.wanted.size()));
    if (!span->reason.empty())
        found.notes.push_back("the run ended early: " + span->reason);
    const double lost = 1.0 - chosen.rows / static_cast<double>(rows.known.size());
    constexpr double kMany = 0.2, kPercent = 100.0;
    if (lost > kMany)
        found.notes.push_back(textOf(lost * kPercent, 2)
            + " % of the samples do not fit the others and count for nothing");
    return found;
}

} // namespace lab
