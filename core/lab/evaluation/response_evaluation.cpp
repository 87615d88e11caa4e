#include "lab/evaluation/response_evaluation.h"

#include "base/text.h"
#include "lab/evaluation/segments.h"
#include "lab/evaluation/step_evaluation.h"
#include "lab/happenings.h"
#include "lab/maths/cross_spectra.h"
#include "lab/maths/statistics.h"
#include "recorded/gain_stretches.h"
#include "scope/sample_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace lab {

namespace {

constexpr double kPeriod_s = 1e-3; ///< as near to it as whole samples are
/// Shorter ones leak from below, where the speed moves most.
constexpr double kTransform_s = 2.048;
/// Of a frequency: bins this near are taken together, at most so many:
constexpr double kBand = 0.25;
constexpr std::size_t kMostBins = 4;
constexpr double kLowest_hz = 2.0, kHighest_hz = 60.0; ///< what the course excites
constexpr double kHighestExchanged_hz = 200.0; ///< by set-points that leave with every exchange
/// Of an observed speed: beyond these it says little of the shaft's, once what follows the current is taken out, and as
/// it was.
constexpr double kCorrected_hz = 25.0, kObserved_hz = 10.0;
constexpr int kLeastSegments = 4;
enum Signal : std::size_t { Speed, Current, Reference, Sensed, kSignals };

/// The signals of a recording: of the board's control loop, or as they came with each exchange.
struct Signals {
    /// The current's reference, the current, the speed; of those that were exchanged the speed's reference.
    std::vector<const capture::Channel *> all;
    const capture::Channel *turns = nullptr; ///< the angle, or the speed
    bool exchanged = false;

    Signals(const capture::Capture &capture, const RecordedMotor &of)
        : exchanged(of.angle.empty())
    {
        turns =
            exchanged ? polledChannel(capture, of.speed, "rpm") : fastChannel(capture, of.angle);
        if (exchanged)
            all = {polledChannel(capture, of.reference, "A"),
                polledChannel(capture, of.current, "A"), turns,
                polledChannel(capture, of.speedReference, "rpm")};
        else
            all = {fastChannel(capture, of.reference), fastChannel(capture, of.current),
                fastChannel(capture, of.speed)};
    }
    bool whole() const { return turns != nullptr && std::ranges::find(all, nullptr) == all.end(); }
    std::vector<Segment> between(Nanos from, Nanos to) const
    {
        constexpr double kExchange_s = 1e-3, kFarthest_s = 0.1;
        return exchanged ? segmentsOfReads(*turns, all, from, to, kExchange_s, kFarthest_s)
                         : segmentsOf(*turns, all, from, to);
    }
    /// A computer that has other work is late now and then: how much of the time straight lines stand for exchanges.
    double bridged(Nanos from, Nanos to) const
    {
        constexpr double kLate_s = 5e-3;
        double last_s = 0.0, late_s = 0.0;
        const auto add = [&](double at_s, double, bool) {
            late_s += at_s - last_s > kLate_s ? at_s - last_s : 0.0;
            last_s = at_s;
        };
        if (exchanged)
            scope::SampleRange(*turns, from, to).visit(add);
        return last_s > 0.0 ? late_s / last_s : 0.0;
    }
};

struct Edge {
    Nanos at = 0;
    double rpm = 0.0; ///< from then on
};

/// When each set-point took effect: by the jump that it makes, or as late as the others where that is not found.
class Edges {
public:
    Edges(const Recorded<ResponsePlan> &plan, const capture::Channel &reference)
        : m_plan(plan)
        , m_reference(reference)
    {
    }
    void accept(Nanos at, const recorded::Happening &what)
    {
        if (what.name == "speed ramp" && numberOf(what, "motor") == m_plan.motor
            && numberOf(what, "ms") == 0.0) {
            finish(at);
            const double rpm = numberOf(what, "rpm").value_or(0.0);
            m_left = false;
            m_open = StepAsked{m_last, rpm, at, at, at};
            m_last = rpm;
        } else if (what.name == "motion" && m_open && what.field("act") == "SPEED_RAMP") {
            const Nanos asked = capture::toNanos(numberOf(what, "asked s").value_or(0.0));
            const Nanos took = capture::toNanos(numberOf(what, "took ms").value_or(0.0) * 1e-3);
            m_open->answered = std::clamp(asked + took, m_open->asked, m_open->asked + kSecond);
        } else if (what.name == "speed ramp" || what.name == "command" || what.name == "stop"
            || endsLink(what) || what.name == kEndEntry) {
            finish(at);
            m_commanded = true;
            m_left = !edges.empty();
            over = over || what.name == kEndEntry;
            if (over && what.field("outcome") != "complete")
                reason = what.field("reason");
        } else if (changesGains(m_plan.motor, what)) {
            // What the plan lends is written before the first command, and given back behind the last edge.
            const bool lends = m_plan.plan.kp > 0 && !m_commanded;
            gainsChanged = gainsChanged || (!lends && !m_left);
        }
    }
    std::vector<Edge> edges;
    bool gainsChanged = false; ///< from the plan to the last edge
    std::string reason; ///< why it ended early
    bool over = false;
    Nanos end = 0; ///< of what the last edge holds for

    void settle()
    {
        if (m_late.empty())
            return;
        const double late = medianOf(m_late);
        for (const std::size_t edge : m_unsure)
            edges[edge].at += static_cast<Nanos>(late);
    }

private:
    static constexpr Nanos kSecond = 1'000'000'000;

    void finish(Nanos at)
    {
        if (!m_open)
            return;
        StepAsked asked = *m_open;
        m_open.reset();
        asked.until = end = at;
        const auto instant = asked.from == 0.0
            ? std::nullopt
            : stepInstant(m_reference, asked, m_plan.regulator.proportional);
        if (instant)
            m_late.push_back(static_cast<double>(instant->at - asked.asked));
        else
            m_unsure.push_back(edges.size());
        edges.push_back({instant ? instant->at : asked.asked, asked.to});
    }

    const Recorded<ResponsePlan> &m_plan;
    const capture::Channel &m_reference;
    std::optional<StepAsked> m_open;
    double m_last = 0.0;
    bool m_commanded = false; ///< by anything since the plan
    bool m_left = false; ///< behind the last edge
    std::vector<double> m_late; ///< from being asked for to the jump
    std::vector<std::size_t> m_unsure;
};

double sinc(double x)
{
    const double phase = std::numbers::pi * x;
    return std::abs(phase) < 1e-9 ? 1.0 : std::sin(phase) / phase;
}

/// How often signals are taken, once in about a millisecond, and what their means leave of a frequency.
struct Pace {
    Pace(double sample_s, bool ofExchanged)
        : step_s(sample_s)
        , exchanged(ofExchanged)
        , every(2 * static_cast<std::size_t>(std::max(1L, std::lround(kPeriod_s / sample_s / 2.0))))
    {
    }
    double step_s; ///< between two samples
    bool exchanged;
    std::size_t every; ///< samples; even, so that one of them is in the middle of a mean

    double period_s() const { return static_cast<double>(every) * step_s; }
    /// Samples of a transform, even.
    std::size_t transform() const
    {
        return 2 * static_cast<std::size_t>(std::lround(kTransform_s / period_s() / 2.0));
    }
    /// Of a current: the mean by trapezoids over a period.
    double ofMean(double hz, int periods = 1) const
    {
        const double phase = std::numbers::pi * hz * step_s, many = double(periods) * double(every);
        return std::sin(many * phase) / (many * std::tan(phase));
    }
    /// Of the shaft's speed: the difference of its angle over two periods, which may be the sum of its speed.
    double ofSpeed(double hz) const
    {
        return exchanged ? ofMean(hz, 2) : sinc(2.0 * hz * period_s());
    }
};

/// Signals once a period: the set-point, then those of Signal.
std::array<std::vector<double>, kSignals + 1> resampled(
    const Segment &segment, const std::vector<Edge> &edges, double polePairs, const Pace &pace)
{
    std::array<std::vector<double>, kSignals + 1> signals;
    const std::size_t every = pace.every;
    const double toRad = std::numbers::pi / 180.0 / (pace.exchanged ? 1.0 : polePairs);
    const auto mean = [&](std::size_t value, std::size_t from) {
        const std::vector<double> &samples = segment.values[value];
        double sum = (samples[from] + samples[from + every]) / 2.0;
        for (std::size_t i = from + 1; i < from + every; ++i)
            sum += samples[i];
        return sum / static_cast<double>(every);
    };
    auto edge = edges.begin();
    for (std::size_t at = every; at + 2 * every < segment.turned_deg.size(); at += every) {
        const std::size_t centre = at + every / 2;
        const Nanos time = segment.at + capture::toNanos(static_cast<double>(centre) * pace.step_s);
        while (edge + 1 != edges.end() && (edge + 1)->at <= time)
            ++edge;
        signals[0].push_back(pace.exchanged ? mean(3, at) : edge->rpm);
        signals[1 + Speed].push_back(
            (segment.turned_deg[centre + every] - segment.turned_deg[centre - every]) * toRad
            / (2.0 * pace.period_s()));
        signals[1 + Current].push_back(mean(1, at));
        signals[1 + Reference].push_back(mean(0, at));
        signals[1 + Sensed].push_back(mean(2, at));
    }
    return signals;
}

/// What does not follow the set-point, of one signal; Hann's window takes 3/8 of the power.
double noiseOf(const CrossSpectra &spectra, std::size_t signal, int transforms)
{
    constexpr double kHann = 0.375, kBothSides = 2.0;
    const auto size = 2.0 * static_cast<double>(spectra.instrument.size() - 1);
    double sum = 0.0;
    for (std::size_t bin = 1; bin < spectra.instrument.size(); ++bin)
        sum += (1.0 - spectra.coherence(signal, bin)) * spectra.own[signal][bin];
    return std::sqrt(kBothSides * sum / (kHann * size * size * transforms));
}

/// @param found  with the regulator that closed its loop
void addPoints(SpeedResponse &found, const CrossSpectra &fine, const Pace &pace)
{
    for (std::size_t first = static_cast<std::size_t>(kLowest_hz / fine.binHz), width = 1;
         first + width <= fine.instrument.size(); first += width) {
        const double lowest = static_cast<double>(first) * fine.binHz;
        width = std::clamp<std::size_t>(
            static_cast<std::size_t>(kBand * lowest / fine.binHz), 1, kMostBins);
        const CrossSpectra spectra = fine.band(first, width);
        constexpr std::size_t bin = 0;
        ResponsePoint point;
        point.hz = lowest + static_cast<double>(width - 1) / 2.0 * fine.binHz;
        point.coherence = std::min(spectra.coherence(Speed, bin), spectra.coherence(Current, bin));
        if (point.hz < kLowest_hz
            || point.hz > (pace.exchanged ? kHighestExchanged_hz : kHighest_hz)
            || point.coherence < kLeastMarginCoherence)
            continue;
        const auto cross = [&](Signal signal) { return spectra.cross[signal][bin]; };
        point.plant =
            cross(Speed) / cross(Current) * pace.ofMean(point.hz) / pace.ofSpeed(point.hz);
        point.relative = std::sqrt(varianceOf(spectra.coherence(Speed, bin), spectra.averages)
            + varianceOf(spectra.coherence(Current, bin), spectra.averages));
        // What the set-point makes of the speed.
        const Complex follows = cross(Sensed) / spectra.instrument[bin];
        if (pace.exchanged)
            point.loop = follows / (1.0 - follows);
        else if (found.regulator.proportional != 0.0)
            point.loop = cross(Sensed) / cross(Reference) * regulatorAt(found.regulator, point.hz);
        point.loopRelative = std::sqrt(varianceOf(spectra.coherence(Sensed, bin), spectra.averages)
            + varianceOf(spectra.coherence(Reference, bin), spectra.averages));
        if (pace.exchanged)
            point.loopRelative =
                std::sqrt(varianceOf(spectra.coherence(Sensed, bin), spectra.averages))
                / std::abs(1.0 - follows);
        found.points.push_back(point);
    }
}

/// What is told of a written register behind a word, e.g. 350 of "ok, was 700, is 350"; empty: nothing.
std::string_view toldBehind(std::string_view told, std::string_view word)
{
    const std::size_t place = told.find(word);
    if (place == std::string_view::npos)
        return {};
    told.remove_prefix(place + word.size());
    return told.substr(0, told.find(','));
}

constexpr std::string_view kDivisor = "_DIV"; ///< of a gain: what its digits weigh
constexpr double kNormal = 1.96; ///< 95 % to either side, in standard errors

/// @param hz, phase  where the loop is 1, and its phase there in rad
/// @param relative  standard error of the loop there
void addCrossover(FrequencyResponse &found, const std::vector<const ResponsePoint *> &points,
    double hz, double phase, double relative)
{
    // How gain and phase fall around it, by the logarithm of the frequency.
    constexpr double kFarOff = 1.5, kLeastSlope = 0.2;
    double squares = 0.0, gains = 0.0, phases = 0.0;
    for (const ResponsePoint *point : points) {
        const double far = std::log(point->hz / hz);
        if (std::abs(far) > std::log(kFarOff))
            continue;
        squares += far * far;
        gains += far * std::log(std::abs(point->loop));
        phases += far * std::remainder(std::arg(point->loop) - phase, 2.0 * std::numbers::pi);
    }
    const double slope =
        squares > 0.0 ? std::max(kLeastSlope, std::abs(gains / squares)) : kLeastSlope;
    const double off = kNormal * relative / slope;
    found.crossover_hz = Estimate{hz, hz * std::exp(-off), hz * std::exp(off)};
    const double toDegrees = 180.0 / std::numbers::pi;
    const double margin = std::remainder(phase * toDegrees + 180.0, 360.0);
    const double half =
        toDegrees * std::hypot(kNormal * relative, squares > 0.0 ? off * phases / squares : 0.0);
    found.phaseMargin_deg = Estimate{margin, margin - half, margin + half};
}

/// An observer is not quite what is taken out: of simulated motors up to a sixth of it was left.
constexpr double kLeft = 0.2;

/// An observed angle follows the current, too, by c: measured is G + c s. Of one inertia with friction, 1 / G is
/// (s + p) / K, so that -w / Im(1 / (G + c s)) is c w^2 - K near enough, whatever p is.
/// @return  c in rad/A, if it can be told: not where that is no straight line, as with two masses
std::optional<Estimate> angleByCurrent(const std::vector<ResponsePoint> &points)
{
    constexpr double kClear = 0.8, kMostResidual = 2.0; ///< times what is expected, as squares
    constexpr std::size_t kLeastPoints = 6;
    struct Place {
        double square, value, off; ///< w^2; of the line; its standard error
    };
    std::vector<Place> places;
    double sum = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const ResponsePoint &point : points) {
        if (point.coherence < kClear || point.hz > kCorrected_hz)
            continue;
        const Complex inverse = 1.0 / point.plant;
        if (!(inverse.imag() > 0.0))
            continue;
        const double w = 2.0 * std::numbers::pi * point.hz, square = w * w;
        const double value = -w / inverse.imag();
        const double off =
            std::max(std::abs(value / inverse.imag() * inverse) * point.relative, 1e-6);
        const double weight = 1.0 / (off * off);
        places.push_back({square, value, off});
        sum += weight;
        x += weight * square;
        y += weight * value;
        xx += weight * square * square;
        xy += weight * square * value;
    }
    const double spread = sum * xx - x * x;
    if (places.size() < kLeastPoints || !(spread > 0.0))
        return std::nullopt;
    const double c = (sum * xy - x * y) / spread, half = kNormal * std::sqrt(sum / spread);
    const double start = (y - c * x) / sum;
    double residual = 0.0;
    for (const Place &place : places)
        residual += std::pow((place.value - start - c * place.square)
                / std::hypot(place.off, kLeft * c * place.square),
            2);
    if (residual > kMostResidual * static_cast<double>(places.size() - 2))
        return std::nullopt;
    return Estimate{c, c - half, c + half};
}

} // namespace

void correctObserved(SpeedResponse &found, double polePairs)
{
    const auto c = angleByCurrent(found.points);
    const double top_hz = c ? kCorrected_hz : kObserved_hz;
    for (ResponsePoint &point : found.points) {
        point.plantKnown = point.hz <= top_hz;
        if (!c)
            continue;
        const double w = 2.0 * std::numbers::pi * point.hz;
        const double unsure = w * std::hypot((*c->high - c->value) / kNormal, kLeft * c->value);
        const double noise = point.relative * std::abs(point.plant);
        point.plant -= Complex(0.0, c->value * w);
        point.relative = std::hypot(noise, unsure) / std::abs(point.plant);
    }
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    found.notes.push_back(c
            ? "what is taken for the angle of a rotor without an encoder follows its current, by "
                + decimalText(c->value * polePairs * kDegrees, 3)
                + " electrical degrees an ampere if all that turns is one inertia: that is taken "
                  "out, and above 25 Hz the motor's own response is not told"
            : "above 10 Hz the motor's own response is not told: what is taken for the "
              "angle of a rotor without an encoder follows its current, too");
}

bool changesGains(int motor, const recorded::Happening &what)
{
    if (what.name != "ended")
        return false;
    return std::ranges::any_of(what.fields, [motor](const auto &field) {
        std::string_view name = field.first;
        const std::size_t at = name.find('@');
        const int of =
            at == std::string_view::npos ? 1 : numberIn<int>(name.substr(at + 1)).value_or(0);
        name = name.substr(0, at);
        if (name.ends_with(kDivisor))
            name.remove_suffix(kDivisor.size());
        if (of != motor || !recorded::isGain(name))
            return false;
        const std::string_view is = toldBehind(field.second, ", is ");
        return is.empty() ? field.second.starts_with("unknown")
                          : is != toldBehind(field.second, ", was ");
    });
}

double varianceOf(double coherence, int averages)
{
    return coherence > 0.0 ? (1.0 - coherence) / (2.0 * averages * coherence) : 1.0;
}

void addMargins(FrequencyResponse &found, double leastCoherence)
{
    constexpr double kWidest = 1.4; // from one point to the next: more is not guessed
    std::vector<const ResponsePoint *> sure;
    for (const ResponsePoint &point : found.points)
        if (point.coherence >= leastCoherence)
            sure.push_back(&point);
    for (const ResponsePoint *point : sure) {
        const double away = std::abs(1.0 + point->loop);
        // Beyond all points the loop ends, where it is 1.
        if (found.ms && 1.0 / away <= found.ms->value)
            continue;
        const double half = kNormal * point->loopRelative * std::abs(point->loop) / (away * away);
        found.ms = Estimate{std::max(1.0, 1.0 / away), std::max(1.0, 1.0 / away - half),
            std::max(1.0, 1.0 / away + half)};
    }
    for (std::size_t at = 1; at < sure.size() && !found.crossover_hz; ++at) {
        const ResponsePoint &a = *sure[at - 1], &b = *sure[at];
        const double above = std::log(std::abs(a.loop)), below = std::log(std::abs(b.loop));
        if (!(above >= 0.0 && below < 0.0) || b.hz > kWidest * a.hz)
            continue;
        const double share = above / (above - below);
        const double phase = std::arg(a.loop)
            + share * std::remainder(std::arg(b.loop) - std::arg(a.loop), 2.0 * std::numbers::pi);
        addCrossover(found, sure, a.hz + share * (b.hz - a.hz), phase,
            std::hypot((1.0 - share) * a.loopRelative, share * b.loopRelative));
    }
    if (!found.crossover_hz)
        found.notes.emplace_back("the loop's gain does not fall through 1 where it could be "
                                 "measured: no margin is told");
}

Complex regulatorAt(const SpeedRegulator &regulator, double hz)
{
    const Complex delay = std::polar(1.0, -2.0 * std::numbers::pi * hz * regulator.period_s);
    const Complex hold = sinc(hz * regulator.period_s)
        * std::polar(1.0, -std::numbers::pi * hz * regulator.period_s);
    return (regulator.proportional + regulator.integral / (1.0 - delay)) * hold;
}

Result<SpeedResponse, std::string> evaluateResponse(
    const capture::Capture &capture, const Happenings &all)
{
    const auto [plan, after] = planIn<ResponsePlan>(all);
    if (!plan || plan->plan.current != 0)
        return fail(std::string("it is no recording of a speed's frequency response"));
    const Signals signals(capture, *plan);
    if (!signals.whole())
        return fail(std::string("it holds no samples of the signals that it needs"));
    Edges edges(*plan, *signals.all[0]);
    for (auto at = after.begin(); at != after.end() && !edges.over; ++at)
        edges.accept(at->first, at->second);
    edges.settle();
    if (edges.edges.empty())
        return fail(std::string("the set-point was never moved in it"));
    if (edges.gainsChanged)
        return fail(std::string(kGainsChanged));
    const std::vector<Segment> segments = signals.between(edges.edges.front().at, edges.end);
    const Pace pace(segments.empty() ? kPeriod_s : segments.front().step_s, signals.exchanged);
    if (auto why = tooFarApart(pace.step_s, false); !why.empty())
        return fail(std::move(why));
    CrossSpectrum sum(pace.transform(), 1.0 / pace.period_s(), kSignals);
    for (const Segment &segment : segments)
        sum.add(resampled(segment, edges.edges, plan->polePairs, pace));
    if (sum.count() < kLeastSegments)
        return fail(
            std::string("too little of it is without a gap: stretches of two seconds are needed"));
    SpeedResponse found;
    found.regulator = plan->regulator;
    const CrossSpectra fine = sum.result();
    found.referenceNoise_a = noiseOf(fine, Reference, sum.count());
    addPoints(found, fine, pace);
    if (found.points.empty())
        return fail(std::string("nothing in it follows the set-point"));
    if (!signals.exchanged && !byEncoder(plan->angle))
        correctObserved(found, plan->polePairs);
    constexpr double kNoticeable = 0.01, kPercent = 100.0;
    if (const double late = signals.bridged(edges.edges.front().at, edges.end); late > kNoticeable)
        found.notes.push_back("for " + decimalText(late * kPercent, 2)
            + " % of the time no exchange came for 5 ms or longer: straight lines stand there");
    noteGaps(found.notes, missingIn(segments));
    noteEnd(found.notes, edges.over, edges.reason);
    if (signals.exchanged || plan->regulator.proportional != 0.0)
        addMargins(found, kLeastMarginCoherence);
    return found;
}

} // namespace lab
