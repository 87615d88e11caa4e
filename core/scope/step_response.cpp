#include "scope/step_response.h"

#include "scope/edges.h"

#include <algorithm>
#include <cmath>

namespace scope {

namespace {
double mean(const capture::Channel &channel, Nanos from, Nanos to, double otherwise)
{
    const auto moments = SampleRange(channel, from, to).moments();
    return moments ? moments->mean : otherwise;
}
} // namespace

StepResponse::StepResponse(const SampleRange &range, const StepSettings &settings)
    : m_after(range.channel(),
        std::clamp(settings.at.value_or(range.from()), range.from(), range.to()), range.to())
    , m_settings(settings)
{
    if (m_after.end() < m_after.begin() + 3)
        m_whyNot = WhyNot::NoSamples;
    else if (m_after.gapInside())
        m_whyNot = WhyNot::GapInside;
    else
        findValues(range, settings);
    if (!m_whyNot)
        findSettling(settings);
}

void StepResponse::findValues(const SampleRange &range, const StepSettings &settings)
{
    const capture::Channel &channel = range.channel();
    const Nanos stop = std::max(channel.timeOf(m_after.end() - 1), m_after.from());
    const double length = capture::toSeconds(stop - m_after.from());
    m_tailStart = length * (1.0 - std::clamp(settings.tail, 0.0, 1.0));
    const Nanos tailStart = m_after.toNanos(m_tailStart);
    const double last = channel.at(m_after.end() - 1);
    m_final = settings.final.value_or(mean(channel, tailStart, range.to(), last));
    const double first = channel.at(m_after.begin());
    m_initial = settings.initial.value_or(mean(channel, range.from(), m_after.from(), first));
    // A step that the noise of its own end hides is none.
    const auto tail = SampleRange(channel, tailStart, range.to()).moments();
    const double noise = tail ? tail->deviation : 0.0;
    if (!(std::abs(m_final - m_initial) > 2.0 * noise) || !std::isfinite(m_final - m_initial))
        m_whyNot = WhyNot::NoStep;
}

/// The last entry into the band, with the moment between the samples.
void StepResponse::findSettling(const StepSettings &settings)
{
    const double band = settings.band * std::abs(m_final - m_initial);
    double before = 0.0;
    double beforeValue = m_initial;
    bool outside = true;
    double entry = 0.0;
    m_after.visit([&](double time, double value, bool joined) {
        const bool isOutside = std::abs(value - m_final) > band;
        if (outside && !isOutside) {
            const double edge = beforeValue > m_final ? m_final + band : m_final - band;
            const bool onLine = joined && m_after.between() == Between::Line
                && std::abs(beforeValue - m_final) > band;
            entry = onLine ? before + (time - before) * (edge - beforeValue) / (value - beforeValue)
                           : time;
        }
        outside = isOutside;
        before = time;
        beforeValue = value;
    });
    if (!outside && entry <= m_tailStart)
        m_settled = entry;
}

Measurement StepResponse::measure(Quantity quantity) const
{
    Measurement result;
    result.quantity = quantity;
    result.unit = unitOf(quantity);
    if (m_whyNot) {
        result.value = fail(*m_whyNot);
        return result;
    }
    switch (quantity) {
    case Quantity::Rise:
    case Quantity::Fall:
        transit(result);
        break;
    case Quantity::DeadTime:
        deadTime(result);
        break;
    case Quantity::Overshoot:
    case Quantity::Undershoot:
    case Quantity::PeakTime:
        excursion(result);
        break;
    case Quantity::Settling:
        settling(result);
        break;
    case Quantity::SteadyStateError:
        steadyStateError(result);
        break;
    case Quantity::Ripple:
    case Quantity::RippleRms:
        ripple(result);
        break;
    case Quantity::AbsoluteError:
    case Quantity::TimedError:
        errorIntegral(result);
        break;
    default: // no matter of a step
        result.value = fail(WhyNot::NoStep);
    }
    return result;
}

void StepResponse::transit(Measurement &result) const
{
    const bool upwards = m_final > m_initial;
    const auto found = upwards == (result.quantity == Quantity::Rise)
        ? findTransition(m_after, valueAt(0.1), valueAt(0.9))
        : std::nullopt;
    if (!found)
        return result.refuse(WhyNot::NoEdge);
    result.value = found->to - found->from;
    result.points = {
        {m_after.toNanos(found->from), valueAt(0.1)}, {m_after.toNanos(found->to), valueAt(0.9)}};
}

void StepResponse::deadTime(Measurement &result) const
{
    const double level = valueAt(0.05);
    const bool upwards = m_final > m_initial;
    std::optional<double> found;
    double before = 0.0;
    double beforeValue = m_initial;
    m_after.visit([&](double time, double value, bool joined) {
        if (!found && (upwards ? value >= level : value <= level)) {
            const bool onLine = joined && m_after.between() == Between::Line;
            found = onLine
                ? before + (time - before) * (level - beforeValue) / (value - beforeValue)
                : time;
        }
        before = time;
        beforeValue = value;
    });
    if (!found)
        return result.refuse(WhyNot::NoEdge);
    result.value = *found;
    result.points = {{m_after.from(), m_initial}, {m_after.toNanos(*found), level}};
}

void StepResponse::excursion(Measurement &result) const
{
    const SampleRange::Extremes extremes = m_after.extremes();
    const bool upwards = m_final > m_initial;
    const bool wantsMax = upwards != (result.quantity == Quantity::Undershoot);
    const double value = wantsMax ? extremes.max : extremes.min;
    const Index at = wantsMax ? extremes.maxAt : extremes.minAt;
    const double reference = result.quantity == Quantity::Undershoot ? m_initial : m_final;
    if (result.quantity == Quantity::PeakTime)
        result.value = m_after.secondsOf(at);
    else if (result.quantity == Quantity::Overshoot)
        result.value = std::max(0.0, share(value) - 1.0) * 100.0;
    else
        result.value = std::max(0.0, -share(value)) * 100.0;
    result.levels = {{LevelMark::Role::Reference, reference, m_after.from(), m_after.to()}};
    result.points = {{m_after.channel().timeOf(at), value}};
}

void StepResponse::settling(Measurement &result) const
{
    const double band = m_settings.band * (m_final - m_initial);
    const double low = m_final - std::abs(band);
    const double high = m_final + std::abs(band);
    result.levels = {{LevelMark::Role::BandLow, low, m_after.from(), m_after.to()},
        {LevelMark::Role::BandHigh, high, m_after.from(), m_after.to()}};
    if (!m_settled)
        return result.refuse(WhyNot::NotSettled);
    result.value = *m_settled;
    result.points = {
        {m_after.from(), m_initial}, {m_after.toNanos(*m_settled), valueAt(1.0 - m_settings.band)}};
}

void StepResponse::steadyStateError(Measurement &result) const
{
    if (!m_settings.setPoint)
        return result.refuse(WhyNot::NoSetPoint);
    // A final value that was given says nothing about where the signal really went.
    const double reached =
        mean(m_after.channel(), m_after.toNanos(m_tailStart), m_after.to(), m_final);
    result.value = m_settled ? Result<double, WhyNot>(*m_settings.setPoint - reached)
                             : fail(WhyNot::NotSettled);
    result.levels = {
        {LevelMark::Role::Reference, *m_settings.setPoint, m_after.from(), m_after.to()},
        {LevelMark::Role::Measured, reached, m_after.toNanos(m_tailStart), m_after.to()}};
}

void StepResponse::ripple(Measurement &result) const
{
    if (!m_settled)
        return result.refuse(WhyNot::NotSettled);
    const SampleRange settled(m_after.channel(), m_after.toNanos(*m_settled), m_after.to());
    if (settled.empty())
        return;
    const SampleRange::Extremes extremes = settled.extremes();
    result.value = result.quantity == Quantity::Ripple ? extremes.max - extremes.min
                                                       : settled.moments()->deviation;
    result.levels = {{LevelMark::Role::BandLow, extremes.min, settled.from(), settled.to()},
        {LevelMark::Role::BandHigh, extremes.max, settled.from(), settled.to()}};
}

/// Each value for as long as it is known to hold behind the step, also one from before it.
double StepResponse::heldErrorIntegral(bool timed) const
{
    const capture::Channel &channel = m_after.channel();
    const Index begin = m_after.begin();
    double sum = 0.0;
    for (Index at = begin > channel.begin() ? begin - 1 : begin; at < m_after.end(); ++at) {
        const double from = std::max(0.0, m_after.secondsOf(at));
        const double to =
            capture::toSeconds(std::min(m_after.to(), channel.holdUntil(at)) - m_after.from());
        const double error = std::abs(*m_settings.setPoint - channel.at(at));
        if (to > from)
            sum += error * (timed ? (to * to - from * from) / 2 : to - from);
    }
    return sum;
}

/// Trapezoids over fast samples.
double StepResponse::fastErrorIntegral(bool timed) const
{
    double sum = 0.0;
    double before = 0.0;
    double beforeError = 0.0;
    m_after.visit([&](double time, double value, bool joined) {
        const double error = std::abs(*m_settings.setPoint - value) * (timed ? time : 1.0);
        if (joined)
            sum += (time - before) * (beforeError + error) / 2;
        before = time;
        beforeError = error;
    });
    return sum;
}

void StepResponse::errorIntegral(Measurement &result) const
{
    if (!m_settings.setPoint)
        return result.refuse(WhyNot::NoSetPoint);
    const bool timed = result.quantity == Quantity::TimedError;
    result.value =
        m_after.between() == Between::Hold ? heldErrorIntegral(timed) : fastErrorIntegral(timed);
    result.levels = {
        {LevelMark::Role::Reference, *m_settings.setPoint, m_after.from(), m_after.to()}};
}

} // namespace scope
