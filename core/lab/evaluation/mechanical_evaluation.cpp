#include "lab/evaluation/mechanical_evaluation.h"

#include "lab/evaluation/flux_fit.h"
#include "lab/evaluation/mechanical_rows.h"
#include "lab/evaluation/segments.h"
#include "lab/experiment.h"
#include "lab/happenings.h"
#include "lab/maths/least_squares.h"
#include "scope/sample_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lab {

namespace {

constexpr double kEdge_s = 5e-3; ///< to either side of an instant, for its speed
constexpr double kReadEdge_s = 25e-3; ///< the same of speeds that were read one after the other
/// A speed that a board tells by itself is a mean of some milliseconds, by Hall sensors of a turn, and was read at
/// another time than the current. Friction that grows with the speed is taken for inertia meanwhile.
constexpr double kReadLag_s = 20e-3;
/// Of all that follows from reads: such a board tells neither its sensor nor how salient its rotor is.
constexpr double kReadUnsure = 0.03;
constexpr double kLeastTime_s = 3.0;
/// What a fit does not see of itself: the current is known to a digit, which is a torque that is always there, and
/// scales to a few parts in a thousand.
constexpr double kTorqueScale = 5e-3;
constexpr double kFluxDiffers = 0.03; ///< from what the board tells: more than its voltages are off
/// What Hall sensors make of a torque is unsure by this share of hallLag(): the most that was seen of simulated motors,
/// 36 that differ in speed, poles, inertia and brake. Nothing is told where it is more than a few percent.
constexpr double kByLag = 0.5, kMostUnsure = 0.1;

/// Wb, as the board tells it.
double fluxOf(const Recorded<SpinPlan> &spin) { return spin.torquePerAmp / (1.5 * spin.polePairs); }

/// To either side of an instant. Steps of the angle by Hall sensors are in no window shorter than an electrical turn;
/// whole halves of a row's distance, so that windows meet.
double edgeOf(const Recorded<SpinPlan> &spin)
{
    constexpr double kHalf = 30.0; // of a minute, in s
    if (spin.angle.empty())
        return kReadEdge_s;
    const double turns = std::max(1, std::abs(spin.plan.lowRpm)) * spin.polePairs;
    return byHall(spin.angle) ? kEdge_s * std::ceil(kHalf / turns / kEdge_s) : kEdge_s;
}

/// How far Hall sensors are behind, as a share of the speed: root mean square. Between two of their edges the angle
/// runs on by a speed that was, the mean over six edges, as firmware has it of itself; so it lags by half of an
/// electrical turn.
double hallLag(
    const Recorded<SpinPlan> &spin, std::span<const MechanicalInstant> instants, const Fit &fit)
{
    if (!byHall(spin.angle) || instants.empty())
        return 0.0;
    double squares = 0.0;
    for (const MechanicalInstant &one : instants) {
        const double speed = std::max(std::abs(one.speed), 1e-3);
        const double friction = fit.values[kViscous] * speed + fit.values[kDry];
        const double held = std::copysign(friction, one.speed) + fit.values[kAlways];
        const double change = std::abs(one.torque_nm - held) / fit.values[kInertia];
        const double lag_s = std::numbers::pi / (spin.polePairs * speed);
        const double share = std::min(1.0, change * lag_s / speed);
        squares += share * share;
    }
    return std::sqrt(squares / static_cast<double>(instants.size()));
}

/// To either side by itself: what cannot be below 0 has its value at one end.
void grow(Estimate &one, double by)
{
    one.low = std::max(0.0, one.value - std::hypot(one.value - *one.low, by));
    one.high = one.value + std::hypot(*one.high - one.value, by);
}

/// What is unsure of all torques, by a share, is so of what it follows from, too; most of all of what tells two
/// frictions apart.
void widen(Mechanics &found, const Recorded<SpinPlan> &spin, double share)
{
    const double toRad = 2.0 * std::numbers::pi / 60.0;
    const double low = std::abs(spin.plan.lowRpm) * toRad,
                 high = std::abs(spin.plan.highRpm) * toRad;
    const double friction = found.dry_nm.value + found.viscous_nms.value * (low + high) / 2.0
        + found.fan_nms2.value * high * high;
    const double slope = 2.0 * share * friction / (high - low);
    grow(found.inertia_kgm2, share * found.inertia_kgm2.value);
    grow(found.viscous_nms, slope);
    grow(found.dry_nm, share * friction + slope * low);
    grow(found.fan_nms2, slope / high);
}

/// Around both.
void cover(Estimate &one, const Estimate &other)
{
    one.low = std::max(0.0, std::min(*one.low, *other.low));
    one.high = std::max(*one.high, *other.high);
}

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

struct Fits {
    const Rows &rows; ///< of both
    const Fit &plain, &fan; ///< without a fan, and with one
    /// The plain one would have a friction below 0: something grows faster than the speed.
    bool impossible;
    double fastest; ///< rad/s
    double digit_nm; ///< of the current
    double unsure; ///< share of all torques
};

/// @param unsure  besides
Estimate told(const Fit &fit, std::size_t unknown, double unsure)
{
    const Estimate own = fit.estimate(unknown);
    const double half = std::hypot((*own.high - *own.low) / 2.0, unsure);
    return {own.value, own.value - half, own.value + half};
}

/// The numbers of the model that explains the run.
Mechanics mechanicsOf(const Recorded<SpinPlan> &spin, const Fits &fits)
{
    Mechanics found;
    const Fit &plain = fits.plain, &fan = fits.fan;
    const double fastest = fits.fastest, digit_nm = fits.digit_nm, unsure = fits.unsure;
    // A fan that takes next to nothing is none.
    const bool impossible = fits.impossible;
    // Torques that are off by some share bend a friction as a fan does, by a few times as much.
    constexpr double kNoticeable = 0.05, kBends = 10.0;
    const double friction = fan.values[kViscous] * fastest + fan.values[kDry];
    const double blown = fan.values[kFan] * fastest * fastest;
    const bool better = fan.estimate(kFan).low > 0.0 && blown > kNoticeable * friction
        && (impossible || explainsBetter(fits.rows, fan, plain));
    found.fan = better && (impossible || blown > (kNoticeable + kBends * unsure) * friction);
    const auto tell = [&](const Fit &fit, Mechanics &into) {
        into.inertia_kgm2 = told(fit, kInertia, 0.0);
        into.viscous_nms = told(fit, kViscous, digit_nm / fastest);
        into.dry_nm = told(fit, kDry, digit_nm);
    };
    tell(found.fan ? fan : plain, found);
    found.fan_nms2 = told(fan, kFan, digit_nm / (fastest * fastest));
    if (!found.fan)
        found.fan_nms2 = {0.0, 0.0, std::max(0.0, *found.fan_nms2.high)};
    widen(found, spin, std::hypot(unsure, kTorqueScale));
    if (better && !found.fan) { // it might be one
        Mechanics other;
        tell(fan, other);
        cover(found.inertia_kgm2, other.inertia_kgm2);
        cover(found.viscous_nms, other.viscous_nms);
        cover(found.dry_nm, other.dry_nm);
        if (byHall(spin.angle))
            found.notes.emplace_back(
                "part of the friction may be a fan's: the angle of Hall sensors at "
                "these speeds does not tell the one from the other");
    }
    return found;
}

/// Of those that cannot be below 0.
std::vector<Estimate *> numbersOf(Mechanics &of)
{
    std::vector<Estimate *> all{&of.inertia_kgm2, &of.viscous_nms, &of.dry_nm, &of.fan_nms2};
    if (of.both)
        all.insert(all.end(), {&of.both->forwards_kgm2, &of.both->backwards_kgm2});
    return all;
}

void scale(Estimate &one, double by) { one = {one.value * by, *one.low * by, *one.high * by}; }

/// By a share of each.
void growAll(Mechanics &found, double share)
{
    for (Estimate *one : numbersOf(found))
        grow(*one, share * one->value);
    if (found.both)
        found.both->always_nm = withScale(found.both->always_nm, share);
}

/// What a salient rotor adds where the board stands aside of it, as a share of the torques: part of a current flows
/// along the magnets then, and makes a torque with the rest of it. How far an observer stands aside is not known.
double hiddenTorque(
    const Recorded<SpinPlan> &spin, std::span<const MechanicalInstant> instants, const Aside &aside)
{
    constexpr double kObserver = 0.09; // 5 degrees; ipm48's is 4 aside with a brake of a quarter
    const double sine = byEncoder(spin.angle) ? std::abs(aside.sine)
        : byHall(spin.angle)                  ? 0.0
                                              : kObserver;
    double squares = 0.0;
    for (const MechanicalInstant &one : instants)
        squares += one.torque_nm * one.torque_nm;
    const double current =
        std::sqrt(squares / static_cast<double>(instants.size())) / spin.torquePerAmp;
    return sine * spin.saliency_h * current / fluxOf(spin);
}

/// The torques were counted with it already.
void allowFor(Mechanics &found, const Aside &aside)
{
    growAll(found, aside.unsure);
    constexpr double kNoticed_deg = 8.0; // 1 % of the torque
    const double angle_deg = std::abs(std::asin(aside.sine)) * 180.0 / std::numbers::pi;
    if (angle_deg > kNoticed_deg)
        found.notes.push_back("the board takes its rotor for " + decimalText(angle_deg, 2)
            + " electrical degrees beside where it is, as after an alignment against friction: its "
              "torque was counted by that");
}

/// All torques are counted with the flux that the board tells. Where its voltages say clearly otherwise they are right.
void compareFlux(Mechanics &found, const Estimate &measured_wb, double told_wb)
{
    const double ratio = measured_wb.value / told_wb;
    const double unsure = (*measured_wb.high - *measured_wb.low) / 2.0 / told_wb;
    if (std::abs(ratio - 1.0) <= kFluxDiffers + unsure) {
        // Which of them is right is unknown, and voltages have a scale of their own.
        constexpr double kBoth = 2.0;
        return growAll(found, kBoth * (ratio - 1.0));
    }
    for (Estimate *one : numbersOf(found))
        scale(*one, ratio);
    if (found.both)
        scale(found.both->always_nm, ratio);
    growAll(found, kFluxDiffers + unsure);
    constexpr double kPercent = 100.0;
    found.notes.push_back("the voltages tell magnets of " + decimalText(measured_wb.value * 1e3, 3)
        + " mWb, the board of " + decimalText(told_wb * 1e3, 3) + " mWb ("
        + decimalText((ratio - 1.0) * kPercent, 2)
        + " %): the voltages were believed; perhaps the angle of its rotor is off, as after an "
          "alignment against friction");
}

/// Whether the first torque was asked for when the runner waited for a speed at rest no longer. @param from  when that
/// was
bool beganSwinging(const Happenings &asked, int motor, Nanos from)
{
    constexpr double kNanosPerMs = 1e6;
    constexpr double kSooner_ms = 50.0; // a ramp that was too late was asked for again
    double waited_ms = 0.0; // since the last ramp was over
    for (const auto &[at, what] : asked)
        if (at < from && what.name == "speed ramp" && numberOf(what, "motor") == motor)
            waited_ms = (static_cast<double>(from) - static_cast<double>(at)) / kNanosPerMs
                - numberOf(what, "ms").value_or(0.0);
    return waited_ms
        >= std::chrono::duration<double, std::milli>(kSwingsAfter + SpinPlan::kListen).count()
        - kSooner_ms;
}

/// What each direction tells of the inertia by itself, and both of a torque that is always there. Empty: one of them
/// tells no inertia.
/// @param together  the fit of both  @param unsure  share of all torques
std::optional<BothWays> bothWays(const Rows &forwards, const Rows &backwards, const Fit &together,
    double digit_nm, double unsure)
{
    // One direction knows the sum of it and dry friction, which may be below 0.
    std::vector<std::size_t> columns{kInertia, kViscous, kAlways, kTilt};
    if (together.values[kFan] != 0.0)
        columns.push_back(kFan);
    const auto inertiaBy = [&](const Rows &rows) -> std::optional<Estimate> {
        const auto fit = fitOf(rows, columns);
        if (!fit || !(fit->values[kInertia] > 0.0))
            return std::nullopt;
        return told(*fit, kInertia, unsure * fit->values[kInertia]);
    };
    const auto one = inertiaBy(forwards), other = inertiaBy(backwards);
    if (!one || !other)
        return std::nullopt;
    return BothWays{*one, *other,
        told(together, kAlways, std::hypot(digit_nm, unsure * together.values[kAlways]))};
}

/// The inertia of both is none that a direction contradicts.
void compareWays(Mechanics &found)
{
    constexpr double kDiffers = 0.2, kNoticed = 0.05, kPercent = 100.0; // of it; of the friction
    const auto &[forwards, backwards, always] = *found.both;
    Estimate &inertia = found.inertia_kgm2;
    inertia.low = std::min({*inertia.low, forwards.value, backwards.value});
    inertia.high = std::max({*inertia.high, forwards.value, backwards.value});
    const double apart = std::abs(forwards.value - backwards.value) / inertia.value;
    if (apart > kDiffers)
        found.notes.push_back("the inertia that its two directions tell is "
            + decimalText(apart * kPercent, 2)
            + " % apart: perhaps its load is another one backwards");
    const bool known = *always.low > 0.0 || *always.high < 0.0;
    if (known && std::abs(always.value) > kNoticed * found.dry_nm.value)
        found.notes.push_back("a torque of " + decimalText(std::abs(always.value), 3)
            + " N m is always there and drives it "
            + (always.value > 0.0 ? "backwards" : "forwards"));
}

/// As FluxValue has them, as far as they were recorded.
std::vector<const capture::Channel *> signalsOf(
    const capture::Capture &capture, const Recorded<SpinPlan> &plan)
{
    std::vector<const capture::Channel *> signals;
    for (const std::string *name : {&plan.current, &plan.voltage, &plan.voltageD, &plan.currentD}) {
        const capture::Channel *channel = fastChannel(capture, *name);
        if (channel == nullptr)
            break;
        signals.push_back(channel);
    }
    return signals;
}

/// What was recorded while torques drove the motor, in one direction or in both.
struct DrivenRun {
    std::vector<DrivenSpan> spans; ///< of each direction; empty: it was never driven
    std::vector<Segment> turning; ///< while the rotor turned
    std::size_t ofFirst = 0; ///< so many of these are of the first direction
    double stood_s = 0.0, missing_s = 0.0;
    bool ofTwo = false; ///< the other direction was to follow
    bool ofReads = false; ///< nothing was recorded at the rate of the control loop
};

/// Its signals.
struct SpinChannels {
    bool read; ///< one after the other: `turns` is the speed
    const capture::Channel *turns, *current; ///< nullptr: it was not recorded
    bool whole() const { return turns != nullptr && current != nullptr && !turns->empty(); }
};

SpinChannels channelsOf(const capture::Capture &capture, const Recorded<SpinPlan> &plan)
{
    if (plan.angle.empty())
        return {true, polledChannel(capture, plan.speed, "rpm"),
            polledChannel(capture, plan.current, "A")};
    return {false, fastChannel(capture, plan.angle), fastChannel(capture, plan.current)};
}

/// Of the current, in A; of one that was read the least that two values differ by.
double digitOf(const SpinChannels &channels, Nanos from, Nanos to)
{
    if (!channels.read)
        return std::abs(channels.current->info().digit());
    double least = 0.0, before = 0.0;
    scope::SampleRange(*channels.current, from, to).visit([&](double, double value, bool joined) {
        const double differs = joined ? std::abs(value - before) : 0.0;
        if (differs > 0.0 && (least == 0.0 || differs < least))
            least = differs;
        before = value;
    });
    return least;
}

DrivenRun drivenRun(const capture::Capture &capture, const SpinChannels &channels,
    const Recorded<SpinPlan> &plan, const Happenings &after)
{
    DrivenRun run;
    run.ofReads = channels.read;
    const capture::Channel &turns = *channels.turns;
    const auto leadsTo = [&plan](const recorded::Happening &what, int rpm) {
        return what.name == "speed ramp" && numberOf(what, "motor") == plan.motor
            && std::abs(numberOf(what, "rpm").value_or(0.0)) == std::abs(rpm);
    };
    const auto ramps = [&](const recorded::Happening &what) {
        return leadsTo(what, plan.plan.lowRpm) || leadsTo(what, plan.plan.highRpm);
    };
    // Before the first way up a motor without a sensor may not have been seen.
    const auto begins = [&](const Happenings::value_type &one) {
        return leadsTo(one.second, plan.plan.highRpm) || one.second.name == kEndEntry;
    };
    const auto add = [&](Happenings::const_iterator at) {
        const Nanos last = turns.timeOf(turns.end() - 1);
        const auto span = channels.read ? drivenSpan(plan.motor,
                              std::find_if(at, after.end(), begins), after.end(), last, ramps)
                                        : drivenSpan(plan.motor, at, after.end(), last);
        if (!span)
            return;
        run.spans.push_back(*span);
        const auto all = channels.read
            ? segmentsOfReads(turns, std::array{channels.current}, span->from, span->to)
            : segmentsOf(turns, signalsOf(capture, plan), span->from, span->to);
        const auto turning = whileTurning(all, leastTurning_degPerS(plan), edgeOf(plan));
        run.stood_s += timeOf(all) - timeOf(turning);
        run.missing_s += missingIn(all);
        run.turning.insert(run.turning.end(), turning.begin(), turning.end());
    };
    add(after.begin());
    run.ofFirst = run.turning.size();
    const auto other = std::ranges::find_if(
        after, [&](const auto &later) { return isOtherWay(later.second, plan); });
    run.ofTwo = other != after.end();
    if (run.ofTwo && !run.spans.empty())
        add(other);
    const auto second = run.turning.begin() + static_cast<std::ptrdiff_t>(run.ofFirst);
    if (timeOf({second, run.turning.end()}) < kLeastTime_s)
        run.turning.erase(second, run.turning.end()); // it says nothing of the flux, either
    return run;
}

MechanicalRows rowsOf(std::span<const Segment> segments, const MechanicalFacts &facts)
{
    MechanicalRows rows(facts);
    for (const Segment &segment : segments)
        rows.accept(segment);
    return rows;
}

/// What of the run is not as it was meant. @param both  whether both directions were evaluated
void noteRun(Mechanics &found, const DrivenRun &run, bool both, const RecordedMotor &of,
    const Happenings &after)
{
    if (!run.ofReads && std::ranges::any_of(run.spans, [&](const DrivenSpan &span) {
            return beganSwinging(after, of.motor, span.from);
        }))
        found.notes.emplace_back(
            "the speed did not come to rest before the first torque: its speed loop swings");
    if (run.ofReads)
        found.notes.push_back("its board records nothing by itself, and its torques "
                              "are counted by "
            + decimalText(of.torquePerAmp, 3) + " N m for an ampere, as was given");
    if (run.ofTwo && !both)
        found.notes.emplace_back("it was driven in one of its two directions only");
    noteGaps(found.notes, run.missing_s);
    noteEnd(found.notes, run.spans.back().over, run.spans.back().reason);
    constexpr double kNoticed_s = 0.02;
    if (run.stood_s > kNoticed_s)
        found.notes.push_back("the rotor nearly stood still for " + decimalText(run.stood_s, 2)
            + " s: that time was left out");
}

} // namespace

bool isOtherWay(const recorded::Happening &what, const Recorded<SpinPlan> &of)
{
    const auto found = recordedPlan<SpinPlan>(what);
    return found && found->motor == of.motor && found->plan == otherWay(of.plan);
}

Result<Mechanics, std::string> evaluateMechanics(
    const capture::Capture &capture, const Happenings &asked)
{
    auto [plan, after] = planIn<SpinPlan>(asked);
    if (!plan)
        return fail(std::string("it is no recording of a mechanical identification"));
    const SpinChannels channels = channelsOf(capture, *plan);
    if (!channels.whole())
        return fail(std::string("it holds no samples of the signals that it needs"));
    if (channels.read)
        plan->polePairs = 1.0; // its speed is the rotor's
    DrivenRun run = drivenRun(capture, channels, *plan, after);
    if (run.spans.empty())
        return fail(std::string("the motor was never driven by a torque in it"));
    std::vector<Segment> &segments = run.turning;
    const double edge_s = edgeOf(*plan);
    const double told_wb = fluxOf(*plan);
    const auto flux =
        channels.read ? std::nullopt : fitFlux(segments, std::max(kFluxWindow_s, 2.0 * edge_s));
    Aside aside;
    // An observer follows voltages itself; Hall sensors are where they were built in, and lag more than they are off.
    if (flux && flux->d && byEncoder(plan->angle)) {
        aside = asideOf(*flux->d, told_wb);
        turnCurrents(segments, aside);
    }
    // Long stretches tell a fan from friction; in them the lag of Hall sensors is taken for inertia.
    constexpr double kStretch_s = 1.0, kHallStretch_s = 0.5;
    const MechanicalFacts facts{plan->polePairs, plan->torquePerAmp, edge_s,
        byHall(plan->angle) ? kHallStretch_s : kStretch_s};
    const std::span<const Segment> all(segments);
    const MechanicalRows first = rowsOf(all.first(run.ofFirst), facts);
    const MechanicalRows second = rowsOf(all.subspan(run.ofFirst), facts);
    const bool both = std::min(first.time_s, second.time_s) >= kLeastTime_s;
    const MechanicalRows stretches = both ? rowsOf(all, facts)
        : first.time_s >= second.time_s   ? first
                                          : second;
    const Rows &rows = stretches.rows;
    if (stretches.time_s < kLeastTime_s)
        return fail("the motor turned for only " + decimalText(stretches.time_s, 2)
            + " s of it without a gap; " + decimalText(kLeastTime_s, 2) + " s are needed");
    std::vector<std::size_t> unknowns{kInertia, kViscous, kDry, kTilt};
    if (both)
        unknowns.push_back(kAlways);
    const auto plain = fitOf(rows, unknowns);
    const bool impossible = plain && plain->unknowns < unknowns.size();
    unknowns.push_back(kFan);
    const auto fan = fitOf(rows, unknowns);
    if (!plain || !fan || !(plain->values[kInertia] > 0.0))
        return fail(std::string("the speed hardly changed: no inertia follows from it"));
    const double lag = kByLag * hallLag(*plan, stretches.instants, *plain);
    if (lag > kMostUnsure)
        return fail(
            "this motor changes its speed too fast for its Hall sensors: between two of their "
            "edges their angle is too far from the rotor's to tell a torque");
    const double digit_nm =
        plan->torquePerAmp * digitOf(channels, run.spans.front().from, run.spans.back().to);
    const double turn_rad = stretches.fastest * plan->polePairs * segments.front().period_s;
    const double unsure = std::hypot(lag, seldomSeen(turn_rad));
    Mechanics found =
        mechanicsOf(*plan, {rows, *plain, *fan, impossible, stretches.fastest, digit_nm, unsure});
    if (unsure > lag)
        found.notes.push_back(seldomSeenNote(turn_rad));
    if (channels.read)
        grow(found.inertia_kgm2,
            kReadLag_s
                * (found.viscous_nms.value + 2.0 * found.fan_nms2.value * stretches.fastest));
    const Fit &chosen = found.fan ? *fan : *plain;
    if (both) {
        const bool forwards = plan->plan.highRpm > 0;
        found.both =
            bothWays(forwards ? first.rows : second.rows, forwards ? second.rows : first.rows,
                chosen, digit_nm, std::hypot(unsure, kTorqueScale));
    }
    growAll(found, channels.read ? kReadUnsure : hiddenTorque(*plan, stretches.instants, aside));
    allowFor(found, aside);
    if (flux)
        compareFlux(found, flux->q, told_wb * aside.cosine);
    if (found.both)
        compareWays(found);
    double squares = 0.0;
    for (const double torque : rows.wanted)
        squares += torque * torque;
    found.share = chosen.residual / std::sqrt(squares / static_cast<double>(rows.wanted.size()));
    noteRun(found, run, both, *plan, after);
    const double lost = 1.0 - chosen.rows / static_cast<double>(rows.known.size());
    constexpr double kMany = 0.2, kPercent = 100.0;
    if (lost > kMany)
        found.notes.push_back(decimalText(lost * kPercent, 2)
            + " % of the samples do not fit the others and count for nothing");
    return found;
}

} // namespace lab
