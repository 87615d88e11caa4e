#include "lab/evaluation/electrical_evaluation.h"

#include "lab/evaluation/segments.h"
#include "lab/evaluation/turning_fit.h"
#include "lab/happenings.h"
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
/// Of the inductances, beside what the rows leave open: a jump of the current lasts a few samples, and Lq is told by
/// those alone. Less well where the angle, too, is known in jumps. Source: simulated motors (docs/experiments.md).
constexpr double kAlong = 0.02, kAlongByHall = 0.035, kJump = 0.04, kJumpByHall = 0.1;
constexpr std::size_t kCurrentQ = 0, kCurrentD = 1, kVoltageQ = 2, kVoltageD = 3, kReference = 4;

/// The segments of a motor's currents and voltages, and of whichever reference was recorded.
std::vector<Segment> segmentsFor(
    const RecordedMotor &motor, const capture::Capture &capture, Nanos from, Nanos to, bool rests)
{
    std::vector<std::string> others{motor.current, motor.currentD, motor.voltage};
    if (rests) {
        const bool along = fastChannel(capture, motor.referenceD) != nullptr;
        others.insert(others.end(), {motor.voltageD, along ? motor.referenceD : motor.reference});
    }
    return segmentsOf(capture, motor.angle, others, from, to);
}

double mean(const std::vector<double> &values, std::size_t from, std::size_t to)
{
    double sum = 0.0;
    for (std::size_t at = from; at < to; ++at)
        sum += values[at];
    return sum / static_cast<double>(to - from);
}

constexpr std::size_t kResistance = 0, kDeadTime = 1;

/// Rows of the plateaus of a motor at rest: the second half of each, where nothing changes any more.
class Plateaus {
public:
    /// @param seen  the rotor is, by a sensor: what turns meanwhile is not at rest
    Plateaus(double nominal_a, bool seen)
        : m_least_a(kLeast * nominal_a)
        , m_seen(seen)
    {
    }
    void accept(const Segment &segment)
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
    /// Of each row, all of it along q; empty: it is not known at which angle.
    std::vector<std::optional<PhaseCurrents>> currents;
    double weakest_a = 1e9, strongest_a = 0.0;
    std::size_t turning = 0; ///< rows that are left out for it

private:
    static constexpr double kLeast = 0.05; ///< of the nominal current
    static constexpr double kLeast_s = 0.15, kWindow_s = 20e-3;
    static constexpr double kRests_deg = 1.0; ///< electrical, in a window

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
            const double turned = segment.turned_deg[from + length - 1] - segment.turned_deg[from];
            if (m_seen && std::abs(turned) > kRests_deg) {
                ++turning;
                continue;
            }
            weakest_a = std::min(weakest_a, amps);
            strongest_a = std::max(strongest_a, amps);
            const double angle_rad = segment.angle_rad(from) - std::atan2(d, q);
            const bool aligns = m_seen && std::abs(q) > std::abs(d); // at an angle that is its own
            currents.push_back(
                aligns ? std::nullopt : std::optional(PhaseCurrents(angle_rad, amps, 0.0)));
            rows.known.push_back({amps, 1.0});
            rows.wanted.push_back((of(kVoltageQ) * q + of(kVoltageD) * d) / amps);
            rows.cluster.push_back(rows.cluster.size());
        }
    }
    double m_least_a;
    bool m_seen;
};

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

struct Turning {
    std::vector<TurningSlices> slices;
    double aside_rad = 0.0;
    bool seesJumps = true; ///< of the current: samples are near enough to each other
};

/// In slices of half a millisecond, or of two samples where these are further apart, as those of slow links.
/// @param times  of that
Turning turningFrom(const std::vector<Segment> &segments, double times)
{
    constexpr double kSlice_s = 0.5e-3, kLeastSamples = 2.0;
    // A voltage that makes a current jump is over within a millisecond: of samples further apart hardly one is in it.
    constexpr double kNear_s = 0.34e-3;
    constexpr double kFarthest_s = 1.1e-3; // those of a link of 115200 baud
    Turning turning;
    for (const Segment &segment : segments) {
        if (segment.step_s > kFarthest_s)
            continue;
        TurningSlices one =
            slicesOf(segment, times * std::max(kSlice_s, kLeastSamples * segment.step_s));
        if (one.all.empty())
            continue;
        turning.seesJumps = turning.seesJumps && segment.step_s <= kNear_s;
        turning.slices.push_back(std::move(one));
    }
    turning.aside_rad = rotorSpeeds(turning.slices);
    return turning;
}

/// What another length of the slices changes is not known, and as much again.
Estimate withLength(const Estimate &found, const Estimate &coarse)
{
    return withScale(found, 2.0 * std::abs(coarse.value / found.value - 1.0));
}

/// An encoder that was aligned against friction: the magnets make a voltage along d, too, and inductances that differ
/// are mixed.
void applyAside(Electrics &found, double aside_rad)
{
    constexpr double kNoticed_deg = 8.0; // 1 % of the flux
    constexpr double kMost_deg = 60.0; // there a degree changes the flux by 3 %, and beyond by more
    const double angle_deg = std::abs(aside_rad) * 180.0 / std::numbers::pi;
    const bool told = angle_deg <= kMost_deg;
    if (told)
        for (double *value : {&found.flux_wb->value, &*found.flux_wb->low, &*found.flux_wb->high})
            *value /= std::cos(aside_rad);
    else
        found.flux_wb.reset();
    constexpr double kAnyDiffer = 1.0; // where Lq is not told: twice Ld is much
    const double differ =
        found.lq_h ? std::abs(found.lq_h->value / found.ld_h->value - 1.0) : kAnyDiffer;
    const double mixed = (told ? std::sin(std::abs(aside_rad)) : 1.0) * differ;
    found.ld_h = withScale(*found.ld_h, mixed);
    if (found.lq_h)
        found.lq_h = withScale(*found.lq_h, mixed);
    if (!told)
        found.notes.emplace_back(
            "by what its currents do to its speed, the board takes its rotor for "
            "more than 60 electrical degrees beside where it is: its flux is "
            "not told");
    else if (angle_deg > kNoticed_deg)
        found.notes.push_back("the board takes its rotor for " + decimalText(angle_deg, 2)
            + " electrical degrees beside where it is, as after an alignment against friction: its "
              "magnets were counted by that");
}

/// What is known so far.
struct Parts {
    Electrics found;
    std::optional<Plateaus> rest;
    std::optional<TurningFit> turning;
    double bus_v = 0.0; ///< what a board's full scale of voltage is of
    double period_s = 0.0; ///< of the control loops, while it turned
    double missing_s = 0.0; ///< samples, of both
};

/// @return  why nothing follows, empty if it does
std::string addResting(Parts &parts, const Recorded<RestPlan> &rest,
    const capture::Capture &capture, Happenings::const_iterator at, Happenings::const_iterator end)
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
    Plateaus plateaus(rest.nominalAmps, byEncoder(rest.angle) || byHall(rest.angle));
    const std::vector<Segment> segments = segmentsFor(rest, capture, from, to, true);
    parts.missing_s += missingIn(segments);
    for (const Segment &segment : segments)
        plateaus.accept(segment);
    constexpr double kLeastRatio = 1.3;
    if (!(plateaus.strongest_a >= kLeastRatio * plateaus.weakest_a))
        return plateaus.turning > 0 ? "the rotor turned where it was to rest: neither its "
                                      "resistance nor the angle that it was aligned to is sure"
                                    : "at rest no two different currents were held for long enough";
    const auto fit = leastSquares(plateaus.rows, std::array{kResistance, kDeadTime});
    if (!fit || !(fit->values[kResistance] > 0.0))
        return "at rest no resistance follows from the voltages";
    parts.found.rs_ohm = withScale(fit->estimate(kResistance), kScaleAtRest);
    parts.found.deadTime_v = fit->estimate(kDeadTime);
    parts.rest = std::move(plateaus);
    return {};
}

std::string addTurning(Parts &parts, const Recorded<SpinPlan> &spin,
    const capture::Capture &capture, Happenings::const_iterator at, Happenings::const_iterator end)
{
    const auto span = drivenSpan(spin.motor, at, end, std::numeric_limits<Nanos>::max());
    if (!span)
        return "the motor was never driven by a current while it turned";
    if (!(spin.nominalAmps > 0.0))
        return "it does not tell the nominal current of the motor";
    constexpr double kLeastRange = 0.2; // of the nominal current
    const std::vector<Segment> driven = segmentsFor(spin, capture, span->from, span->to, false);
    if (driven.empty())
        return "it holds no samples of the signals that it needs";
    parts.missing_s += missingIn(driven);
    constexpr double kFullScale = 32767.0; // of a phase: bus / sqrt(3)
    parts.bus_v =
        fastChannel(capture, spin.voltage)->info().factor * kFullScale * std::numbers::sqrt3;
    const std::vector<Segment> segments = whileTurning(driven, leastTurning_degPerS(spin));
    const Turning fine = turningFrom(segments, 1.0), longer = turningFrom(segments, 2.0);
    if (fine.slices.empty() || longer.slices.empty())
        return "it holds too few samples of the turning motor without a gap, or they are too far "
               "apart";
    if (!(rangeAlongD(fine.slices) > kLeastRange * spin.nominalAmps))
        return "while it turned the current along the magnets hardly changed";
    Electrics &found = parts.found;
    const bool hall = byHall(spin.angle);
    const auto fitTo = [&](const std::vector<TurningSlices> &rows) {
        return turningFit(rows, {parts.bus_v, spin.nominalAmps},
            found.rs_ohm ? std::optional(found.rs_ohm->value) : std::nullopt,
            hall || !fine.seesJumps);
    };
    const auto fit = fitTo(fine.slices), coarse = fitTo(longer.slices);
    if (!fit || !coarse || (fine.seesJumps && !(fit->lq_h && coarse->lq_h)))
        return "while it turned no inductance follows from the voltages";
    found.ld_h = withLength(withScale(fit->ld_h, hall ? kAlongByHall : kAlong), coarse->ld_h);
    if (fine.seesJumps)
        found.lq_h = withLength(withScale(*fit->lq_h, hall ? kJumpByHall : kJump), *coarse->lq_h);
    else
        found.notes.emplace_back(
            "its samples are too far apart to tell the inductance across the magnets, which only "
            "jumps of the current tell");
    found.flux_wb = withLength(withScale(fit->flux_wb, kVoltageScale), coarse->flux_wb);
    double fastest = 0.0;
    for (const TurningSlices &one : fine.slices)
        for (const TurningSlice &slice : one.all)
            fastest = std::max(fastest, std::abs(slice.rotorSpeed));
    const double turn_rad = fastest * fine.slices.front().period_s;
    if (const double unsure = seldomSeen(turn_rad); unsure > 0.0) {
        if (found.lq_h)
            found.lq_h = withScale(*found.lq_h, unsure);
        found.notes.push_back(seldomSeenNote(turn_rad));
    }
    if (byEncoder(spin.angle))
        applyAside(found, fine.aside_rad);
    constexpr double kTold = 0.5; // of its value: less is as good as nothing
    if (!(*found.ld_h->low > kTold * found.ld_h->value)) {
        found.ld_h.reset();
        found.notes.emplace_back("it turned too slowly to tell the inductance along the magnets");
    }
    if (!span->reason.empty())
        found.notes.push_back("the run ended early: " + span->reason);
    parts.turning = fit;
    parts.period_s = fine.slices.front().period_s;
    return {};
}

/// Of currents at rest that swing through zero: there what the dead time takes looks like a part of the resistance.
void takeSwingOut(Parts &parts)
{
    const TurningFit &turning = *parts.turning;
    Electrics &found = parts.found;
    // Volts of the bus an ampere.
    const double perSwing = 16.0 * turning.ld_h.value / parts.period_s;
    constexpr double kFarBeyond = 1.5;
    if (parts.bus_v * kFarBeyond > perSwing * parts.rest->strongest_a) {
        // Resistance and dead time are one: td / T of the bus over the current up to which it swings.
        constexpr double kLongest_s = 1.5e-6;
        found.rs_ohm->low =
            std::max(0.0, *found.rs_ohm->low - perSwing * kLongest_s / parts.period_s);
        found.notes.push_back("what the dead time takes cannot be told from the resistance: "
                              "currents swung through zero within a PWM period");
        return;
    }
    if (!(*turning.lost_v.low > 0.0))
        return; // the bridge makes up for its dead time
    const auto rowsWith = [&parts](double swing_a) {
        const Rows &all = parts.rest->rows;
        Rows rows;
        for (std::size_t row = 0; row < all.known.size(); ++row)
            if (const auto &current = parts.rest->currents[row]) {
                rows.known.push_back({all.known[row][kResistance], current->lossAlongQ(swing_a)});
                rows.wanted.push_back(all.wanted[row]);
                rows.cluster.push_back(all.cluster[row]);
            }
        return rows;
    };
    constexpr std::array kBoth{kResistance, kDeadTime};
    const double swing_a = turning.swing_a;
    const Rows rows = rowsWith(swing_a);
    const auto fit = leastSquares(rows, kBoth);
    if (!fit || !(fit->values[kResistance] > 0.0))
        return;
    Estimate rs = withScale(fit->estimate(kResistance), kScaleAtRest);
    constexpr double kUnsure = 1.25; // from one swing that was tried to the next
    for (const double other : {swing_a / kUnsure, swing_a * kUnsure})
        if (const auto beside = leastSquares(rowsWith(other), kBoth)) {
            rs.low = std::min(*rs.low, beside->values[kResistance]);
            rs.high = std::max(*rs.high, beside->values[kResistance]);
        }
    found.rs_ohm = rs;
    // What it takes of one phase, as much as of the voltage along the currents of the rows.
    double along = 0.0;
    for (const Row &row : rows.known)
        along += row[kDeadTime] / static_cast<double>(rows.known.size());
    Estimate lost = fit->estimate(kDeadTime);
    for (double *value : {&lost.value, &*lost.low, &*lost.high})
        *value *= along;
    found.deadTime_v = lost;
}

} // namespace

Figures figuresOf(const Electrics &found)
{
    return {{"rs_ohm", "Resistance", "\u03a9", found.rs_ohm},
        {"ld_h", "Inductance Ld", "H", found.ld_h}, {"lq_h", "Inductance Lq", "H", found.lq_h},
        {"flux_wb", "Flux", "Wb", found.flux_wb},
        {"dead_time_v", "Dead time", "V", found.deadTime_v}};
}

Result<Electrics, std::string> evaluateElectrics(
    const capture::Capture &capture, const Happenings &all)
{
    const Happenings happenings = carriedOut(all);
    Parts parts;
    Electrics &found = parts.found;
    bool any = false, over = false;
    for (auto at = happenings.begin(); at != happenings.end(); ++at) {
        std::string failed;
        if (const auto rest = recordedPlan<RestPlan>(at->second); rest && !found.rs_ohm)
            failed = addResting(parts, *rest, capture, at, happenings.end());
        else if (const auto spin = recordedPlan<SpinPlan>(at->second); spin && !parts.turning)
            failed = addTurning(parts, *spin, capture, at, happenings.end());
        else
            continue;
        any = true;
        over = std::any_of(at, happenings.cend(),
            [](const auto &later) { return later.second.name == kEndEntry; });
        if (!failed.empty())
            found.notes.push_back(failed);
    }
    if (!any)
        return fail(std::string("it is no recording of an electrical identification"));
    if (!found.rs_ohm && !parts.turning)
        return fail(found.notes.empty() ? std::string("nothing follows from it") : found.notes[0]);
    if (parts.rest && found.ld_h)
        takeSwingOut(parts);
    noteGaps(found.notes, parts.missing_s);
    noteEnd(found.notes, over, {}); // why it ended early stands with what turned
    return found;
}

} // namespace lab
