#include "lab/evaluation/mechanical_evaluation.h"

#include "lab/evaluation/driven_span.h"
#include "lab/evaluation/flux_fit.h"
#include "lab/evaluation/segments.h"
#include "lab/fields.h"
#include "lab/maths/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lab {

namespace {

constexpr double kStretch_s = 0.5; ///< in which all is integrated from its beginning
constexpr double kRow_s = 10e-3;
constexpr double kEdge_s = 5e-3; ///< to either side of an instant, for its speed
constexpr std::size_t kInertia = 0, kViscous = 1, kDry = 2, kFan = 3, kTilt = 4, kUnknowns = 5;
constexpr double kLeastStretch_s = 0.1; ///< between two gaps
constexpr double kLeastTime_s = 3.0;
/// What a fit does not see of itself: the current is known to a digit, which is a torque that is always there, and scales to
/// a few parts in a thousand.
constexpr double kScale = 5e-3;
constexpr double kFluxDiffers = 0.03; ///< from what the board tells: more than its voltages are off

/// The rows of all stretches.
class Stretches {
public:
    explicit Stretches(const RecordedSpin &plan)
        : m_plan(plan)
    {
    }

    void take(const Segment &segment)
    {
        const auto edge =
            static_cast<std::size_t>(std::max(1L, std::lround(kEdge_s / segment.step_s)));
        const std::size_t size = segment.turned_deg.size();
        if (size <= 2 * edge)
            return;
        const double time = static_cast<double>(size - 2 * edge) * segment.step_s;
        const auto parts = static_cast<std::size_t>(std::ceil(time / kStretch_s));
        const std::size_t length = (size - 2 * edge) / parts;
        if (length == 0)
            return; // samples so far apart are no board's, but a file may hold them
        for (std::size_t at = edge; at + length + edge <= size; at += length)
            if (static_cast<double>(length) * segment.step_s >= kLeastStretch_s)
                add(segment, at, at + length, edge);
    }
    Rows rows;
    double time_s = 0.0;
    double fastest = 0.0; ///< rad/s

private:
    /// Integrals from its beginning, less their means: what they were before it is not known, and need not be.
    void add(const Segment &segment, std::size_t from, std::size_t to, std::size_t edge)
    {
        const double step_s = segment.step_s;
        const double toRad = std::numbers::pi / 180.0 / m_plan.polePairs; // mechanical
        const auto turned = [&](std::size_t at) { return segment.turned_deg[at] * toRad; };
        const auto speed = [&](std::size_t at) {
            return (turned(at + edge) - turned(at - edge))
                / (2.0 * static_cast<double>(edge) * step_s);
        };
        const auto every = static_cast<std::size_t>(std::max(1L, std::lround(kRow_s / step_s)));
        const double sign = turned(to - 1) < turned(from) ? -1.0 : 1.0;
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
                rows.known.push_back({now, turned(at) - turned(from),
                    sign * static_cast<double>(at - from) * step_s, squares, cubes});
                rows.wanted.push_back(m_plan.torquePerAmp * impulse);
                rows.cluster.push_back(m_count);
                for (std::size_t i = 0; i < kMostUnknowns; ++i)
                    sum[i] += rows.known.back()[i];
                sumWanted += rows.wanted.back();
                row += every;
            }
            const double amps = (segment.values[0][at] + segment.values[0][at + 1]) / 2.0;
            impulse += amps * step_s;
            cubes += amps * amps * amps * step_s;
        }
        const auto many = static_cast<double>(rows.known.size() - first);
        for (std::size_t row = first; row < rows.known.size(); ++row) {
            for (std::size_t i = 0; i < kMostUnknowns; ++i)
                rows.known[row][i] -= sum[i] / many;
            rows.wanted[row] -= sumWanted / many;
        }
        time_s += static_cast<double>(to - from) * step_s;
        ++m_count;
    }

    const RecordedSpin &m_plan;
    std::size_t m_count = 0;
};

double timeOf(const std::vector<Segment> &segments)
{
    double time_s = 0.0;
    for (const Segment &segment : segments)
        time_s += segment.step_s * static_cast<double>(segment.turned_deg.size());
    return time_s;
}

/// What cannot be below 0 is left out where it would be, which may push the other one there.
std::optional<Fit> fitOf(const Rows &rows, std::vector<std::size_t> columns)
{
    auto fit = leastSquares(rows, columns);
    const auto below = [&](std::size_t column) { return fit->values[column] < 0.0; };
    while (fit && (below(kViscous) || below(kDry))) {
        std::erase(columns, below(kViscous) ? kViscous : kDry);
        fit = leastSquares(rows, columns);
    }
    return fit;
}

/// All torques are counted with the flux that the board tells. Where its voltages say clearly otherwise they are right.
void compareFlux(Mechanics &found, const Estimate &measured_wb, double told_wb)
{
    const double ratio = measured_wb.value / told_wb;
    const double unsure = (*measured_wb.high - *measured_wb.low) / 2.0 / told_wb;
    if (std::abs(ratio - 1.0) <= kFluxDiffers + unsure)
        return;
    for (Estimate *one :
        {&found.inertia_kgm2, &found.viscous_nms, &found.dry_nm, &found.fan_nms2}) {
        const double half =
            std::hypot((*one->high - *one->low) / 2.0, (kFluxDiffers + unsure) * one->value);
        one->value *= ratio;
        one->low = std::max(0.0, one->value - ratio * half);
        one->high = one->value + ratio * half;
    }
    constexpr double kPercent = 100.0;
    found.notes.push_back("the voltages tell magnets of " + textOf(measured_wb.value * 1e3, 3)
        + " mWb, the board of " + textOf(told_wb * 1e3, 3) + " mWb ("
        + textOf((ratio - 1.0) * kPercent, 2)
        + " %): the voltages were believed; perhaps the angle of its rotor is off, as after an "
          "alignment against friction");
}

} // namespace

Result<Mechanics, std::string> evaluateMechanics(
    const capture::Capture &capture, const Happenings &asked)
{
    const Happenings happenings = carriedOut(asked);
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
    const auto span =
        drivenSpan(plan->motor, at, happenings.end(), angle->timeOf(angle->end() - 1));
    if (!span)
        return fail(std::string("the motor was never driven by a torque in it"));
    const capture::Channel *voltage = fastChannel(capture, plan->voltage);
    const std::array others{current, voltage == nullptr ? current : voltage};
    const std::vector<Segment> all = segmentsOf(*angle, others, span->from, span->to);
    const std::vector<Segment> segments = whileTurning(all, leastTurning_degPerS(*plan));
    const double stood_s = timeOf(all) - timeOf(segments);
    Stretches stretches(*plan);
    for (const Segment &segment : segments)
        stretches.take(segment);
    const Rows &rows = stretches.rows;
    if (stretches.time_s < kLeastTime_s)
        return fail("the motor turned for only " + textOf(stretches.time_s, 2)
            + " s of it without a gap; " + textOf(kLeastTime_s, 2) + " s are needed");
    const auto plain = fitOf(rows, {kInertia, kViscous, kDry, kTilt});
    const auto fan = fitOf(rows, {kInertia, kViscous, kDry, kFan, kTilt});
    if (!plain || !fan || !(plain->values[kInertia] > 0.0))
        return fail(std::string("the speed hardly changed: no inertia follows from it"));
    Mechanics found;
    const double fastest = stretches.fastest;
    // A friction below 0 in the plain model: something grows faster than the speed. A fan that takes next to nothing is none.
    const bool impossible = plain->unknowns < kUnknowns - 1;
    constexpr double kNoticeable = 0.05;
    const double friction = fan->values[kViscous] * fastest + fan->values[kDry];
    found.fan = fan->estimate(kFan).low > 0.0
        && fan->values[kFan] * fastest * fastest > kNoticeable * friction
        && (impossible || fan->criterion() < plain->criterion());
    const Fit &chosen = found.fan ? *fan : *plain;
    const double digit_nm = plan->torquePerAmp * std::abs(current->info().digit());
    const auto told = [&](const Fit &fit, std::size_t unknown, double digit) {
        const Estimate own = fit.estimate(unknown);
        const double half = std::hypot((*own.high - *own.low) / 2.0, digit, kScale * own.value);
        return Estimate{own.value, own.value - half, own.value + half};
    };
    found.inertia_kgm2 = told(chosen, kInertia, 0.0);
    found.viscous_nms = told(chosen, kViscous, digit_nm / fastest);
    found.dry_nm = told(chosen, kDry, digit_nm);
    found.fan_nms2 = told(*fan, kFan, digit_nm / (fastest * fastest));
    if (!found.fan)
        found.fan_nms2 = {0.0, 0.0, std::max(0.0, *found.fan_nms2.high)};
    const auto flux = voltage == nullptr ? std::nullopt : fitFlux(segments);
    if (flux)
        compareFlux(found, *flux, plan->torquePerAmp / (1.5 * plan->polePairs));
    double squares = 0.0;
    for (const double torque : rows.wanted)
        squares += torque * torque;
    found.share = chosen.residual / std::sqrt(squares / static_cast<double>(rows.wanted.size()));
    if (!span->reason.empty())
        found.notes.push_back("the run ended early: " + span->reason);
    constexpr double kNoticed_s = 0.02;
    if (stood_s > kNoticed_s)
        found.notes.push_back("the rotor all but stood for " + textOf(stood_s, 2)
            + " s of it, which count for nothing");
    const double lost = 1.0 - chosen.rows / static_cast<double>(rows.known.size());
    constexpr double kMany = 0.2, kPercent = 100.0;
    if (lost > kMany)
        found.notes.push_back(textOf(lost * kPercent, 2)
            + " % of the samples do not fit the others and count for nothing");
    return found;
}

} // namespace lab
