#include "lab/evaluation/mechanical_evaluation.h"

#include "lab/evaluation/flux_fit.h"
#include "lab/evaluation/mechanical_rows.h"
#include "lab/evaluation/segments.h"
#include "lab/happenings.h"
#include "lab/maths/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lab {

namespace {

constexpr double kEdge_s = 5e-3; ///< to either side of an instant, for its speed
constexpr std::size_t kUnknowns = 5;
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
        const double change =
            std::abs(one.torque_nm - std::copysign(friction, one.speed)) / fit.values[kInertia];
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
    double fastest; ///< rad/s
    double digit_nm; ///< of the current
    double unsure; ///< share of all torques
};

/// The numbers of the model that explains the run.
Mechanics mechanicsOf(const Recorded<SpinPlan> &spin, const Fits &fits)
{
    Mechanics found;
    const Fit &plain = fits.plain, &fan = fits.fan;
    const double fastest = fits.fastest, digit_nm = fits.digit_nm, unsure = fits.unsure;
    // A friction below 0 in the plain model: something grows faster than the speed. A fan that takes next to nothing is
    // none.
    const bool impossible = plain.unknowns < kUnknowns - 1;
    // Torques that are off by some share bend a friction as a fan does, by a few times as much.
    constexpr double kNoticeable = 0.05, kBends = 10.0;
    const double friction = fan.values[kViscous] * fastest + fan.values[kDry];
    const double blown = fan.values[kFan] * fastest * fastest;
    const bool better = fan.estimate(kFan).low > 0.0 && blown > kNoticeable * friction
        && (impossible || explainsBetter(fits.rows, fan, plain));
    found.fan = better && (impossible || blown > (kNoticeable + kBends * unsure) * friction);
    const auto told = [](const Fit &fit, std::size_t unknown, double digit) {
        const Estimate own = fit.estimate(unknown);
        const double half = std::hypot((*own.high - *own.low) / 2.0, digit);
        return Estimate{own.value, own.value - half, own.value + half};
    };
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

std::array<Estimate *, 4> numbersOf(Mechanics &of)
{
    return {&of.inertia_kgm2, &of.viscous_nms, &of.dry_nm, &of.fan_nms2};
}

/// By a share of each.
void growAll(Mechanics &found, double share)
{
    for (Estimate *one : numbersOf(found))
        grow(*one, share * one->value);
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
    for (Estimate *one : numbersOf(found)) {
        one->value *= ratio;
        one->low = *one->low * ratio;
        one->high = *one->high * ratio;
    }
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

} // namespace

Result<Mechanics, std::string> evaluateMechanics(
    const capture::Capture &capture, const Happenings &asked)
{
    const auto [plan, after] = planIn<SpinPlan>(asked);
    if (!plan)
        return fail(std::string("it is no recording of a mechanical identification"));
    const capture::Channel *angle = fastChannel(capture, plan->angle);
    const capture::Channel *current = fastChannel(capture, plan->current);
    if (angle == nullptr || current == nullptr || angle->empty())
        return fail(std::string("it holds no samples of the signals that it needs"));
    const auto span =
        drivenSpan(plan->motor, after.begin(), after.end(), angle->timeOf(angle->end() - 1));
    if (!span)
        return fail(std::string("the motor was never driven by a torque in it"));
    const std::vector<Segment> all =
        segmentsOf(*angle, signalsOf(capture, *plan), span->from, span->to);
    const double edge_s = edgeOf(*plan);
    std::vector<Segment> segments = whileTurning(all, leastTurning_degPerS(*plan), edge_s);
    const double stood_s = timeOf(all) - timeOf(segments);
    const double told_wb = fluxOf(*plan);
    const auto flux = fitFlux(segments, std::max(kFluxWindow_s, 2.0 * edge_s));
    Aside aside;
    // An observer follows voltages itself; Hall sensors are where they were built in, and lag more than they are off.
    if (flux && flux->d && byEncoder(plan->angle)) {
        aside = asideOf(*flux->d, told_wb);
        turnCurrents(segments, aside);
    }
    // Long stretches tell a fan from friction; in them the lag of Hall sensors is taken for inertia.
    constexpr double kStretch_s = 1.0, kHallStretch_s = 0.5;
    MechanicalRows stretches({plan->polePairs, plan->torquePerAmp, edge_s,
        byHall(plan->angle) ? kHallStretch_s : kStretch_s});
    for (const Segment &segment : segments)
        stretches.accept(segment);
    const Rows &rows = stretches.rows;
    if (stretches.time_s < kLeastTime_s)
        return fail("the motor turned for only " + decimalText(stretches.time_s, 2)
            + " s of it without a gap; " + decimalText(kLeastTime_s, 2) + " s are needed");
    const auto plain = fitOf(rows, {kInertia, kViscous, kDry, kTilt});
    const auto fan = fitOf(rows, {kInertia, kViscous, kDry, kFan, kTilt});
    if (!plain || !fan || !(plain->values[kInertia] > 0.0))
        return fail(std::string("the speed hardly changed: no inertia follows from it"));
    const double lag = kByLag * hallLag(*plan, stretches.instants, *plain);
    if (lag > kMostUnsure)
        return fail(
            "this motor changes its speed too fast for its Hall sensors: between two of their "
            "edges their angle is too far from the rotor's to tell a torque");
    const double digit_nm = plan->torquePerAmp * std::abs(current->info().digit());
    const double turn_rad = stretches.fastest * plan->polePairs * segments.front().period_s;
    const double unsure = std::hypot(lag, seldomSeen(turn_rad));
    Mechanics found = mechanicsOf(*plan, {rows, *plain, *fan, stretches.fastest, digit_nm, unsure});
    if (unsure > lag)
        found.notes.push_back(seldomSeenNote(turn_rad));
    const Fit &chosen = found.fan ? *fan : *plain;
    growAll(found, hiddenTorque(*plan, stretches.instants, aside));
    allowFor(found, aside);
    if (flux)
        compareFlux(found, flux->q, told_wb * aside.cosine);
    double squares = 0.0;
    for (const double torque : rows.wanted)
        squares += torque * torque;
    found.share = chosen.residual / std::sqrt(squares / static_cast<double>(rows.wanted.size()));
    if (beganSwinging(after, plan->motor, span->from))
        found.notes.emplace_back(
            "the speed did not come to rest before the first torque: its speed loop swings");
    noteGaps(found.notes, missingIn(all));
    noteEnd(found.notes, span->over, span->reason);
    constexpr double kNoticed_s = 0.02;
    if (stood_s > kNoticed_s)
        found.notes.push_back("the rotor nearly stood still for " + decimalText(stood_s, 2)
            + " s: that time was left out");
    const double lost = 1.0 - chosen.rows / static_cast<double>(rows.known.size());
    constexpr double kMany = 0.2, kPercent = 100.0;
    if (lost > kMany)
        found.notes.push_back(decimalText(lost * kPercent, 2)
            + " % of the samples do not fit the others and count for nothing");
    return found;
}

} // namespace lab
