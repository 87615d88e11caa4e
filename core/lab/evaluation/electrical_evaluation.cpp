#include "lab/evaluation/electrical_evaluation.h"

#include "lab/evaluation/driven_span.h"
#include "lab/evaluation/segments.h"
#include "lab/evaluation/turning_slices.h"
#include "lab/fields.h"
#include "lab/maths/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace lab {

namespace {

/// Voltages count the real bus, which the board tells in whole volts.
constexpr double kVoltageScale = 0.015;
/// And what a bridge loses grows a little with the current.
constexpr double kScaleAtRest = 0.02;
/// Along the magnets, where a motor that saturates was seen to be 1.7 % lower.
constexpr double kAlong = 0.02;
/// A jump of the current lasts a few samples, and its inductance is told by those alone; less well where the angle, too, is
/// known in jumps. Source: simulated motors (docs/experiments.md).
constexpr double kJump = 0.035, kJumpByHall = 0.1;
constexpr std::size_t kCurrentQ = 0, kCurrentD = 1, kVoltageQ = 2, kVoltageD = 3, kReference = 4;

Estimate withScale(const Estimate &own, double scale)
{
    const double half = std::hypot((*own.high - *own.low) / 2.0, scale * own.value);
    return {own.value, own.value - half, own.value + half};
}

/// The segments of a motor's currents and voltages, and of whichever reference was recorded.
std::vector<Segment> segmentsFor(
    const RecordedMotor &motor, const capture::Capture &capture, Nanos from, Nanos to, bool rests)
{
    const capture::Channel *angle = fastChannel(capture, motor.angle);
    std::vector<const capture::Channel *> others;
    for (const std::string *name : {&motor.current, &motor.currentD, &motor.voltage})
        others.push_back(fastChannel(capture, *name));
    if (rests) {
        others.push_back(fastChannel(capture, motor.voltageD));
        const capture::Channel *along = fastChannel(capture, motor.referenceD);
        others.push_back(along != nullptr ? along : fastChannel(capture, motor.reference));
    }
    if (angle == nullptr || std::find(others.begin(), others.end(), nullptr) != others.end())
        return {};
    return segmentsOf(*angle, others, from, to);
}

double mean(const std::vector<double> &values, std::size_t from, std::size_t to)
{
    double sum = 0.0;
    for (std::size_t at = from; at < to; ++at)
        sum += values[at];
    return sum / static_cast<double>(to - from);
}

constexpr std::size_t kResistance = 0, kDeadTime = 1, kLd = 2, kLq = 3, kFlux = 4;

/// Rows of the plateaus of a motor at rest: the second half of each, where nothing changes any more.
class Plateaus {
public:
    explicit Plateaus(double nominal_a)
        : m_least_a(kLeast * nominal_a)
    {
    }
    void take(const Segment &segment)
    {
        const std::vector<double> &reference = segment.values[kReference];
        for (std::size_t from = 0; from < reference.size();) {
            std::size_t to = from + 1;
            while (to < reference.size() && reference[to] == reference[from])
                ++to;
            if (static_cast<double>(to - from) * segment.step_s >= kLeast_s)
                add(segment, from + (to - from) / 2, to);
            from = to;
        }
    }
    Rows rows;
    double weakest_a = 1e9, strongest_a = 0.0;

private:
    static constexpr double kLeast = 0.05; ///< of the nominal current
    static constexpr double kLeast_s = 0.15, kWindow_s = 20e-3;

    void add(const Segment &segment, std::size_t from, std::size_t to)
    {
        const auto length = static_cast<std::size_t>(std::lround(kWindow_s / segment.step_s));
        for (; length > 0 && from + length <= to; from += length) {
            const auto of = [&](std::size_t signal) {
                return mean(segment.values[signal], from, from + length);
            };
            const double q = of(kCurrentQ), d = of(kCurrentD), amps = std::hypot(q, d);
            if (amps < m_least_a)
                continue;
            weakest_a = std::min(weakest_a, amps);
            strongest_a = std::max(strongest_a, amps);
            rows.known.push_back({amps, 1.0});
            rows.wanted.push_back((of(kVoltageQ) * q + of(kVoltageD) * d) / amps);
            rows.cluster.push_back(rows.cluster.size());
        }
    }
    double m_least_a;
};

/// Rows of a turning motor, one a slice.
Rows rowsOf(const std::vector<TurningSlices> &slices, double least_a)
{
    Rows rows;
    std::size_t cluster = 0;
    for (const TurningSlices &one : slices) {
        constexpr double kCluster_s = 0.1; // what disturbs one slice disturbs the next
        const auto length = static_cast<std::size_t>(std::lround(kCluster_s / one.step_s));
        for (std::size_t at = 0; at < one.all.size(); ++at) {
            const TurningSlice &w = one.all[at];
            cluster += at % length == 0 ? 1 : 0;
            if (std::hypot(w.q_a, w.d_a) < least_a)
                continue;
            rows.known.push_back({w.q_a, w.lossQ, w.speed * w.d_a, w.dq, w.rotorSpeed});
            rows.wanted.push_back(w.q_v);
            rows.cluster.push_back(cluster);
        }
    }
    return rows;
}

/// Greatest less least current along the magnets.
double rangeAlongD(const std::vector<TurningSlices> &slices)
{
    double least = 0.0, most = 0.0;
    for (const TurningSlices &one : slices)
        for (const TurningSlice &slice : one.all) {
            least = std::min(least, slice.d_a);
            most = std::max(most, slice.d_a);
        }
    return most - least;
}

/// @return  why nothing follows, empty if it does
std::string addResting(Electrics &found, const RecordedRest &rest, const capture::Capture &capture,
    Happenings::const_iterator at, Happenings::const_iterator end)
{
    // What was recorded before may go on until the board records what this needs, ahead of the first command.
    const auto commands = [](const auto &happening) {
        return happening.second.name == "current reference" || happening.second.name == "command";
    };
    at = std::find_if(at, end, commands);
    const Nanos from = at == end ? std::numeric_limits<Nanos>::max() : at->first;
    while (at != end && at->second.name != kEndEntry)
        ++at;
    const Nanos to = at == end ? std::numeric_limits<Nanos>::max() : at->first;
    Plateaus plateaus(rest.nominalAmps);
    for (const Segment &segment : segmentsFor(rest, capture, from, to, true))
        plateaus.take(segment);
    constexpr double kLeastRatio = 1.3;
    if (!(plateaus.strongest_a >= kLeastRatio * plateaus.weakest_a))
        return "at rest no two different currents were held for long enough";
    const auto fit = leastSquares(plateaus.rows, std::array{kResistance, kDeadTime});
    if (!fit || !(fit->values[kResistance] > 0.0))
        return "at rest no resistance follows from the voltages";
    found.rs_ohm = withScale(fit->estimate(kResistance), kScaleAtRest);
    found.deadTime_v = fit->estimate(kDeadTime);
    return {};
}

std::string addTurning(Electrics &found, const RecordedSpin &spin, const capture::Capture &capture,
    Happenings::const_iterator at, Happenings::const_iterator end)
{
    const auto span = drivenSpan(spin.motor, at, end, std::numeric_limits<Nanos>::max());
    if (!span)
        return "the motor was never driven by a current while it turned";
    if (!(spin.nominalAmps > 0.0))
        return "it does not tell the nominal current of the motor";
    constexpr double kLeast = 0.1, kSmall = 0.02, kLeastRange = 0.2; // of the nominal current
    std::vector<TurningSlices> slices;
    for (const Segment &segment : whileTurning(
             segmentsFor(spin, capture, span->from, span->to, false), leastTurning_degPerS(spin)))
        if (TurningSlices one = slicesOf(segment, kSmall * spin.nominalAmps); !one.all.empty())
            slices.push_back(std::move(one));
    if (!(rangeAlongD(slices) > kLeastRange * spin.nominalAmps))
        return "while it turned the current along the magnets hardly changed";
    rotorSpeeds(slices);
    const Rows rows = rowsOf(slices, kLeast * spin.nominalAmps);
    const auto fit = leastSquares(rows, std::array{kResistance, kDeadTime, kLd, kLq, kFlux});
    if (!fit || !(fit->values[kLd] > 0.0) || !(fit->values[kLq] > 0.0)
        || !(fit->values[kFlux] > 0.0))
        return "while it turned no inductance follows from the voltages";
    found.ld_h = withScale(fit->estimate(kLd), kAlong);
    const bool hall = spin.angle.starts_with("HALL");
    found.lq_h = withScale(fit->estimate(kLq), hall ? kJumpByHall : kJump);
    found.flux_wb = withScale(fit->estimate(kFlux), kVoltageScale);
    if (!span->reason.empty())
        found.notes.push_back("the run ended early: " + span->reason);
    return {};
}

} // namespace

Result<Electrics, std::string> evaluateElectrics(
    const capture::Capture &capture, const Happenings &all)
{
    const Happenings happenings = carriedOut(all);
    Electrics found;
    bool any = false;
    for (auto at = happenings.begin(); at != happenings.end(); ++at) {
        std::string failed;
        if (const auto rest = recordedRest(at->second); rest && !found.rs_ohm)
            failed = addResting(found, *rest, capture, at, happenings.end());
        else if (const auto spin = recordedSpin(at->second); spin && !found.ld_h)
            failed = addTurning(found, *spin, capture, at, happenings.end());
        else
            continue;
        any = true;
        if (!failed.empty())
            found.notes.push_back(failed);
    }
    if (!any)
        return fail(std::string("it is no recording of an electrical identification"));
    if (!found.rs_ohm && !found.ld_h)
        return fail(found.notes.empty() ? std::string("nothing follows from it") : found.notes[0]);
    return found;
}

} // namespace lab
