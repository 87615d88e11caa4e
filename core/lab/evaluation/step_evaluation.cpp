#include "lab/evaluation/step_evaluation.h"

#include "lab/subject.h"
#include "scope/step_response.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace lab {

namespace {

constexpr Nanos kMilli = 1'000'000;
constexpr Nanos kBefore = 100 * kMilli; ///< of the speed before the step, for its mean
/// A sample's time is that of its board, set to our clock by the packet that came soonest: it is late by what that
/// took.
constexpr Nanos kEarly = 5 * kMilli, kLate = 25 * kMilli;
/// A mean over T makes a rise longer by (T / rise)^2 / 4; over an eighth of it, by 0.4 %. Encoders of few lines need
/// more.
constexpr double kSpeedWindow_s = 5e-3, kLeastWindow_s = 2e-3, kWindowsPerRise = 8.0;
/// A jump may differ by so much from the one that the gain tells.
constexpr double kLikeExpected = 0.25;
constexpr double kAlone = 4.0; ///< without a gain: so much larger than every other one
constexpr double kMinute_s = 60.0, kTurn_deg = 360.0;

struct Jump {
    double at_s = 0.0; ///< since the range began
    double size = 0.0; ///< in the direction of the step
    double behind = 0.0; ///< where it led to
};

/// All jumps of the reference in the direction of the step, and what it is at its ends.
std::vector<Jump> jumpsOf(const scope::SampleRange &range, double direction)
{
    std::vector<Jump> jumps;
    double before = 0.0;
    range.visit([&](double seconds, double value, bool joined) {
        const double size = (value - before) * direction;
        if (joined && size > 0.0)
            jumps.push_back({seconds, size, value});
        before = value;
    });
    return jumps;
}

/// Those that can be the step: as large as the gain tells, or cut short because they led to the end of the reference.
std::vector<Jump> likeExpected(std::vector<Jump> jumps, double expected, double end, double digit)
{
    std::erase_if(jumps, [&](const Jump &jump) {
        const bool asLarge = std::abs(jump.size - expected) <= kLikeExpected * expected;
        const bool cut = jump.size < expected && jump.size > kLikeExpected * expected
            && std::abs(jump.behind - end) <= digit;
        return !asLarge && !cut;
    });
    return jumps;
}

/// The largest, if it stands out.
std::vector<Jump> largest(std::vector<Jump> jumps)
{
    std::sort(
        jumps.begin(), jumps.end(), [](const Jump &a, const Jump &b) { return a.size > b.size; });
    if (jumps.empty() || (jumps.size() > 1 && jumps[0].size < kAlone * jumps[1].size))
        return {};
    jumps.resize(1);
    return jumps;
}

std::optional<double> valueOf(const scope::StepResponse &response, scope::Quantity quantity)
{
    const auto measured = response.measure(quantity).value;
    return measured ? std::optional(*measured) : std::nullopt;
}

/// How much of the time the reference stood at its end in the direction of the step: for two samples or more in a row.
double shareAtLimit(const capture::Channel &reference, Nanos from, Nanos to, bool up)
{
    const scope::SampleRange range(reference, from, to);
    if (range.end() < range.begin() + 2)
        return 0.0;
    const auto ends = range.extremes();
    const double end = up ? ends.max : ends.min;
    // A loop that turns once a millisecond holds each value for less.
    constexpr int kTurnSamples = 64;
    int row = 0, held = 0;
    range.visit([&](double, double value, bool) {
        row = value == end ? row + 1 : 0;
        held += row == kTurnSamples ? kTurnSamples : row > kTurnSamples ? 1 : 0;
    });
    return static_cast<double>(held) / static_cast<double>(range.end() - range.begin());
}

} // namespace

std::optional<StepInstant> stepInstant(
    const capture::Channel &reference, const StepAsked &asked, double jumpPerUnit)
{
    const double step = asked.to - asked.from;
    const double direction = step > 0.0 ? 1.0 : -1.0;
    const scope::SampleRange range(reference, asked.asked - kEarly, asked.answered + kLate);
    if (range.empty() || range.gapInside())
        return std::nullopt;
    const scope::SampleRange whole(reference, asked.asked - kEarly, asked.until);
    const auto ends = whole.extremes();
    const double expected = std::abs(jumpPerUnit * step);
    std::vector<Jump> jumps = jumpsOf(range, direction);
    jumps = expected > 0.0 ? likeExpected(std::move(jumps), expected,
                direction > 0.0 ? ends.max : ends.min, std::abs(reference.info().digit()) * 1.5)
                           : largest(std::move(jumps));
    if (jumps.empty())
        return std::nullopt;
    // Where several could be it, the first is taken, because the loop answers to its own step; how far the others are
    // says how sure that is.
    const Nanos sample = range.end() - range.begin() > 1
        ? reference.timeOf(range.begin() + 1) - reference.timeOf(range.begin())
        : kMilli;
    const Nanos spread = capture::toNanos(jumps.back().at_s - jumps.front().at_s);
    return StepInstant{range.toNanos(jumps.front().at_s), std::max(sample, spread)};
}

capture::Capture speedOf(
    const capture::Channel &angle, double polePairs, double window_s, Nanos from, Nanos to)
{
    const scope::SampleRange range(angle, from, to);
    std::vector<double> turned; // degrees since the range began
    double before = 0.0;
    range.visit([&](double, double value, bool) {
        turned.push_back(
            turned.empty() ? 0.0 : turned.back() + std::remainder(value - before, kTurn_deg));
        before = value;
    });
    capture::Capture result;
    if (turned.size() < 3 || range.gapInside() || !(polePairs > 0.0)
        || !std::isfinite(turned.back()))
        return result;
    const double step_s = range.secondsOf(range.begin() + 1) - range.secondsOf(range.begin());
    const auto window = static_cast<std::size_t>(std::max(1.0, std::round(window_s / step_s)));
    if (turned.size() <= window)
        return result;
    std::vector<double> rpm;
    double most = 1.0;
    for (std::size_t i = window; i < turned.size(); ++i) {
        const double turns = (turned[i] - turned[i - window]) / (kTurn_deg * polePairs);
        rpm.push_back(turns / (static_cast<double>(window) * step_s) * kMinute_s);
        most = std::max(most, std::abs(rpm.back()));
    }
    // As a signal of its own: its digits are a hundred times finer than what an encoder resolves.
    capture::StreamLayout layout;
    layout.id = 1;
    layout.tickHz = 1.0 / step_s;
    layout.originSeconds = capture::toSeconds(angle.timeOf(range.begin()))
        + static_cast<double>(window) / 2.0 * step_s;
    const double digit = most / 32000.0;
    layout.fast = {{angle.info().registerId, "speed from the angle", "rpm", digit}};
    capture::SampleBlock block;
    block.stream = layout.id;
    block.count = static_cast<std::uint32_t>(rpm.size());
    for (const double value : rpm)
        block.fast.push_back(static_cast<std::int16_t>(std::lround(value / digit)));
    result.begin(layout);
    result.append(block);
    return result;
}

std::optional<double> peakOf(const capture::Channel &channel, Nanos from, Nanos to)
{
    const scope::SampleRange range(channel, from, to);
    if (range.empty())
        return std::nullopt;
    const auto ends = range.extremes();
    return std::max(std::abs(ends.min), std::abs(ends.max));
}

void measureStep(StepRun &run, const capture::Channel &response, Nanos from, Nanos until)
{
    scope::StepSettings settings;
    settings.at = run.at;
    const scope::StepResponse step({response, from, until}, settings);
    run.unusable = step.whyNot();
    if (!run.unusable && run.up != (step.final() > step.initial()))
        run.unusable = scope::WhyNot::NoStep;
    if (run.unusable)
        return;
    run.rise_s = valueOf(step, run.up ? scope::Quantity::Rise : scope::Quantity::Fall);
    run.overshoot_pct = valueOf(step, scope::Quantity::Overshoot);
    // Without the instant, what is counted from it is not known.
    if (run.found)
        run.settling_s = valueOf(step, scope::Quantity::Settling);
}

namespace {

/// The values of parabolas through as many neighbours, without the ends. Source: A. Savitzky, M. Golay, Anal. Chem. 36
/// (1964) 1627.
std::vector<double> smoothed(const std::vector<double> &values, std::size_t half)
{
    const double m = double(half), all = (2 * m - 1) * (2 * m + 1) * (2 * m + 3);
    std::vector<double> weights;
    for (double off = -m; off <= m; off += 1.0)
        weights.push_back(3.0 * (3 * m * m + 3 * m - 1 - 5 * off * off) / all);
    std::vector<double> smooth;
    for (std::size_t i = half; i + half < values.size(); ++i)
        smooth.push_back(std::inner_product(
            weights.begin(), weights.end(), values.begin() + std::ptrdiff_t(i - half), 0.0));
    return smooth;
}

/// Overshoot of a speed with noise, whose peak is the noise's, too: smoothed over a part of its rise, less what noise
/// like that of its end adds to such a peak on average (the bootstrap's estimate of a bias: B. Efron, Ann. Statist. 7
/// (1979) 1).
std::optional<double> overshootOf(
    const capture::Channel &speed, const StepRun &run, Nanos until, const scope::StepResponse &step)
{
    constexpr double kShareOfRise = 0.35, kTail = 0.2;
    // Samples; the speed is a mean over a window already, so that more of them smooth hardly better, and they cost
    // their square.
    constexpr std::size_t kMostHalf = 32;
    const scope::SampleRange range(speed, run.at, until);
    if (range.end() < range.begin() + 3 || range.gapInside())
        return std::nullopt;
    const double sample_s = range.secondsOf(range.begin() + 1) - range.secondsOf(range.begin());
    const auto whole = static_cast<std::size_t>(kShareOfRise * *run.rise_s / sample_s);
    const std::size_t every = whole / kMostHalf + 1, half = whole / every;
    std::vector<double> values;
    std::size_t count = 0;
    range.visit([&](double, double value, bool) {
        if (count++ % every == 0)
            values.push_back((value - step.initial()) / (step.final() - step.initial()) - 1.0);
    });
    const auto tail = static_cast<std::size_t>(kTail * double(values.size()));
    if (half < 2 || values.size() < 4 * half)
        return std::nullopt;
    const std::vector<double> smooth = smoothed(values, half);
    const auto peak = std::max_element(smooth.begin(), smooth.end());
    if (*peak <= 0.0)
        return 0.0;
    // What is behind the last value that neighbours reach is no part of the tail.
    const std::size_t quiet = tail > half ? tail - half : 0;
    const auto reach = std::ptrdiff_t(std::min(2 * half, quiet / 2));
    const auto from = peak - std::min(peak - smooth.begin(), reach);
    const auto to = peak + std::min(smooth.end() - peak, reach);
    const auto noise = smooth.end() - std::ptrdiff_t(quiet);
    double bias = 0.0;
    int shifts = 0;
    for (auto at = noise; reach > 0 && smooth.end() - at >= to - from; ++at, ++shifts) {
        double most = 0.0;
        for (auto one = from; one != to; ++one)
            most = std::max(most, *one + *(at + (one - from)));
        bias += most - *peak;
    }
    return shifts == 0 ? *peak * 100.0 : std::max(0.0, *peak - bias / shifts) * 100.0;
}

void measureByAngle(
    StepRun &run, const capture::Channel &angle, double polePairs, double window_s, Nanos until)
{
    run.speedWindow_s = window_s;
    const capture::Capture turned = speedOf(angle, polePairs, window_s, run.at - kBefore, until);
    const auto ids = turned.channels();
    run.rise_s.reset();
    run.overshoot_pct.reset();
    if (ids.empty()) {
        run.unusable = scope::WhyNot::GapInside;
        return;
    }
    const capture::Channel &speed = *turned.channel(ids.front().id);
    measureStep(run, speed, run.at - kBefore, until);
    if (!run.rise_s)
        return;
    scope::StepSettings settings;
    settings.at = run.at;
    if (const auto overshoot = overshootOf(
            speed, run, until, scope::StepResponse({speed, run.at - kBefore, until}, settings)))
        run.overshoot_pct = overshoot;
}

} // namespace

std::optional<StepRun> cutShort(
    const StepAsked &asked, const capture::Channel &response, Nanos hold, Nanos ramp)
{
    constexpr double kWhole = 0.9;
    const Nanos recorded = response.empty() ? 0 : response.timeOf(response.end() - 1);
    const Nanos held = std::min(asked.until, recorded) - asked.asked - ramp;
    if (static_cast<double>(held) >= kWhole * static_cast<double>(hold))
        return std::nullopt;
    StepRun run;
    run.up = asked.to > asked.from;
    run.at = asked.asked;
    run.until = asked.until;
    run.cut = true;
    return run;
}

namespace {

/// A rise of fewer distances than these is a guess: each of its ends is known to one.
constexpr double kDistancesPerRise = 3.0;

StepRun evaluatePolled(const StepChannels &channels, const StepAsked &asked)
{
    const capture::Channel &speed = *channels.speed;
    StepRun run;
    run.up = asked.to > asked.from;
    run.at = asked.asked + (asked.answered - asked.asked) / 2;
    run.until = asked.until;
    run.found = asked.answered > asked.asked;
    const capture::Index first = speed.atOrAfter(asked.asked);
    if (first == speed.begin()) {
        run.unusable = scope::WhyNot::NoSamples;
        return run;
    }
    // From the last value that is certainly of before, so that the first one behind it has a neighbour.
    StepRun seen = run;
    seen.at = speed.timeOf(first - 1);
    measureStep(seen, speed, seen.at - kBefore, asked.until);
    const Nanos over =
        seen.settling_s ? seen.at + capture::toNanos(*seen.settling_s) + kMilli : asked.until;
    const capture::Index end = speed.atOrAfter(over);
    Nanos distance = 0;
    for (capture::Index at = first; at < end; ++at)
        distance = std::max(distance, speed.timeOf(at) - speed.timeOf(at - 1));
    run.pollDistance_s = capture::toSeconds(distance);
    if (run.found)
        run.instantError_s =
            capture::toSeconds((asked.answered - asked.asked) / 2) + run.pollDistance_s;
    run.unusable = seen.unusable;
    run.tooFast =
        !run.unusable && (!seen.rise_s || *seen.rise_s < kDistancesPerRise * run.pollDistance_s);
    if (run.tooFast)
        return run;
    run.rise_s = seen.rise_s;
    run.overshoot_pct = seen.overshoot_pct;
    if (seen.settling_s)
        run.settling_s = *seen.settling_s - capture::toSeconds(run.at - seen.at);
    if (channels.current != nullptr)
        run.peakIq_a = peakOf(*channels.current, asked.asked, asked.until);
    return run;
}

} // namespace

StepRun evaluateStep(const StepChannels &channels, const StepAsked &asked, const StepFacts &facts)
{
    if (channels.reference == nullptr)
        return evaluatePolled(channels, asked);
    StepRun run;
    run.up = asked.to > asked.from;
    const auto instant = stepInstant(*channels.reference, asked, facts.jumpPerRpm);
    run.found = instant.has_value();
    // Not found, it lies anywhere in the range that was searched: what came before that is not the step's.
    run.at = instant ? instant->at : asked.asked - kEarly;
    run.until = asked.until;
    run.instantError_s = capture::toSeconds(
        instant ? instant->error : asked.answered - asked.asked + kEarly + kLate);
    if (channels.current != nullptr)
        run.peakIq_a = peakOf(*channels.current, run.at, asked.until);
    run.atLimit = shareAtLimit(*channels.reference, run.at, asked.until, run.up);
    if (channels.angle == nullptr || !(facts.polePairs > 0.0)) {
        measureStep(run, *channels.speed, run.at - kBefore, asked.until);
        return run;
    }
    // Between two edges of Hall sensors the angle runs on by a speed that was, and it jumps at each: a whole electrical
    // turn has all of them alike. Of a slow motor that would be longer than what is measured.
    constexpr double kLongestTurn_s = 20e-3;
    const double turn_s = kMinute_s
        / (std::max(1.0, std::min(std::abs(asked.from), std::abs(asked.to))) * facts.polePairs);
    const bool hall = byHall(channels.angle->info().name) && turn_s <= kLongestTurn_s;
    const double least_s = std::max(kLeastWindow_s, hall ? turn_s : 0.0);
    measureByAngle(
        run, *channels.angle, facts.polePairs, std::max(kSpeedWindow_s, least_s), asked.until);
    if (run.rise_s && *run.rise_s < kWindowsPerRise * kSpeedWindow_s && least_s < kSpeedWindow_s)
        measureByAngle(run, *channels.angle, facts.polePairs,
            std::max(least_s, *run.rise_s / kWindowsPerRise), asked.until);
    return run;
}

} // namespace lab
