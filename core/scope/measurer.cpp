#include "scope/measurer.h"

#include <algorithm>

namespace scope {

namespace {
/// Of the height, on each side of the middle: noise of 10 % stays inside.
constexpr double kHysteresis = 0.2;
} // namespace

UnitKind unitOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Frequency:
        return UnitKind::Hertz;
    case Quantity::Period:
    case Quantity::Rise:
    case Quantity::Fall:
    case Quantity::PeakTime:
    case Quantity::Settling:
    case Quantity::DeadTime:
        return UnitKind::Seconds;
    case Quantity::Duty:
    case Quantity::Overshoot:
    case Quantity::Undershoot:
        return UnitKind::Percent;
    case Quantity::AbsoluteError:
        return UnitKind::ChannelSeconds;
    case Quantity::TimedError:
        return UnitKind::ChannelSecondsSquared;
    case Quantity::Phase:
        return UnitKind::Degrees;
    default:
        return UnitKind::Channel;
    }
}

Measurer::Measurer(
    const capture::Channel &channel, Nanos from, Nanos to, const std::optional<StepSettings> &step)
    : m_range(channel, from, to)
{
    if (step)
        m_step.emplace(m_range, *step);
}

Measurement Measurer::measure(Quantity quantity)
{
    Measurement result;
    result.quantity = quantity;
    result.unit = unitOf(quantity);
    switch (quantity) {
    case Quantity::Min:
    case Quantity::Max:
    case Quantity::PeakToPeak:
        extremes(result);
        return result;
    case Quantity::Mean:
    case Quantity::Rms:
        moments(result, m_range);
        return result;
    case Quantity::Frequency:
    case Quantity::Period:
    case Quantity::CycleMean:
    case Quantity::CycleRms:
        cycles(result);
        return result;
    case Quantity::Duty:
        duty(result);
        return result;
    case Quantity::Rise:
    case Quantity::Fall:
        if (m_step)
            return m_step->measure(quantity);
        transition(result);
        return result;
    case Quantity::Phase:
        result.value = fail(WhyNot::OtherFrequency);
        return result;
    default:
        if (m_step)
            return m_step->measure(quantity);
        result.value = fail(WhyNot::NoStep);
        return result;
    }
}

void Measurer::extremes(Measurement &result) const
{
    if (m_range.empty())
        return;
    const SampleRange::Extremes found = m_range.extremes();
    const capture::Channel &channel = m_range.channel();
    const PointMark low{channel.timeOf(found.minAt), found.min};
    const PointMark high{channel.timeOf(found.maxAt), found.max};
    result.partial = m_range.gapInside();
    const auto level = [&](double value) {
        result.levels.push_back({LevelMark::Role::Measured, value, m_range.from(), m_range.to()});
    };
    if (result.quantity != Quantity::Max) {
        level(found.min);
        result.points.push_back(low);
    }
    if (result.quantity != Quantity::Min) {
        level(found.max);
        result.points.push_back(high);
    }
    if (result.quantity == Quantity::PeakToPeak)
        result.value = found.max - found.min;
    else
        result.value = result.quantity == Quantity::Min ? found.min : found.max;
}

void Measurer::moments(Measurement &result, const SampleRange &range) const
{
    const auto found = range.moments();
    if (!found)
        return;
    const bool rms = result.quantity == Quantity::Rms || result.quantity == Quantity::CycleRms;
    result.value = rms ? found->rms : found->mean;
    result.partial = range.gapInside();
    result.levels = {{LevelMark::Role::Measured, *result.value, range.from(), range.to()}};
}

const std::optional<SignalLevels> &Measurer::levels()
{
    if (!m_levelsKnown)
        m_levels = findLevels(m_range);
    m_levelsKnown = true;
    return m_levels;
}

/// Why there are no whole periods; nullopt if there are.
std::optional<WhyNot> Measurer::findPeriods()
{
    if (m_range.empty())
        return WhyNot::NoSamples;
    if (m_range.gapInside())
        return WhyNot::GapInside;
    if (!levels())
        return WhyNot::NoFullPeriod;
    if (!m_crossingsKnown)
        m_crossings = findCrossings(m_range, m_levels->at(0.5), kHysteresis * m_levels->height());
    m_crossingsKnown = true;
    return m_crossings.rising.size() < 2 ? std::optional(WhyNot::NoFullPeriod) : std::nullopt;
}

void Measurer::cycles(Measurement &result)
{
    if (const auto why = findPeriods())
        return result.refuse(*why);
    const std::vector<double> &rising = m_crossings.rising;
    if (result.quantity == Quantity::CycleMean || result.quantity == Quantity::CycleRms) {
        moments(result,
            SampleRange(m_range.channel(), m_range.toNanos(rising.front()),
                m_range.toNanos(rising.back())));
        return;
    }
    const double period = (rising.back() - rising.front()) / static_cast<double>(rising.size() - 1);
    result.value = result.quantity == Quantity::Period ? period : 1.0 / period;
    const double middle = m_levels->at(0.5);
    result.levels = {{LevelMark::Role::Reference, middle, m_range.from(), m_range.to()}};
    result.points = {
        {m_range.toNanos(rising.front()), middle}, {m_range.toNanos(rising.back()), middle}};
}

void Measurer::duty(Measurement &result)
{
    if (const auto why = findPeriods())
        return result.refuse(*why);
    const double from = m_crossings.rising.front();
    const double to = m_crossings.rising.back();
    double above = 0.0;
    double counted = from; // up to here: a pulse that dips falls twice and rises once
    auto up = m_crossings.rising.begin();
    for (const double down : m_crossings.falling) {
        // The last upward crossing before this downward one; noise may have made several.
        while (up + 1 != m_crossings.rising.end() && *(up + 1) <= down)
            ++up;
        if (down > from && down < to) {
            above += down - std::max(*up, counted);
            counted = down;
        }
    }
    result.value = above / (to - from) * 100.0;
    const double middle = m_levels->at(0.5);
    result.levels = {
        {LevelMark::Role::Reference, middle, m_range.toNanos(from), m_range.toNanos(to)}};
    result.points = {{m_range.toNanos(from), middle}, {m_range.toNanos(to), middle}};
}

void Measurer::transition(Measurement &result)
{
    if (m_range.empty())
        return;
    if (m_range.gapInside())
        return result.refuse(WhyNot::GapInside);
    if (!levels())
        return result.refuse(WhyNot::NoEdge);
    const bool rise = result.quantity == Quantity::Rise;
    const double start = m_levels->at(rise ? 0.1 : 0.9);
    const double end = m_levels->at(rise ? 0.9 : 0.1);
    const auto found = findTransition(m_range, start, end);
    if (!found)
        return result.refuse(WhyNot::NoEdge);
    result.value = found->to - found->from;
    result.points = {{m_range.toNanos(found->from), start}, {m_range.toNanos(found->to), end}};
    result.levels = {{LevelMark::Role::Reference, m_levels->base, m_range.from(), m_range.to()},
        {LevelMark::Role::Reference, m_levels->top, m_range.from(), m_range.to()}};
}

} // namespace scope
