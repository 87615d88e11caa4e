// The ranges of the plots: time, and values that fit what is visible.
#include "widgets/base/axis_ticks.h"
#include "widgets/scope/drawing/axis_ticker.h"
#include "widgets/scope/plot_stack.h"

#include <algorithm>

namespace widgets {

namespace {
constexpr double kMargin = 0.08; ///< of the span, above and below

/// A range that shows [low, high] with some room, and at least `least` of the unit.
QCPRange roomy(double low, double high, double least)
{
    if (!(high > low) && !(least > 0))
        least = std::max(std::abs(high) * 0.2, 1e-3);
    if (high - low < least) {
        const double middle = low + (high - low) / 2;
        low = middle - least / 2;
        high = middle + least / 2;
    }
    const double span = high - low;
    return {low - span * kMargin, high + span * kMargin};
}
} // namespace

void PlotStack::setTimeRange(double from, double to)
{
    for (const auto &plot : m_plots)
        plot->timeAxis()->setRange(from, to);
}

void PlotStack::setTimeOrigin(double seconds)
{
    m_origin = seconds;
    for (const auto &plot : m_plots)
        plot->timeAxis()->ticker().dynamicCast<AxisTicker>()->setOrigin(seconds);
}

capture::MinMax PlotStack::extremes(const ScopePlot &plot, const QCPAxis *axis) const
{
    const QCPRange range = plot.timeAxis()->range();
    capture::MinMax all;
    for (const Trace &trace : plot.traces) {
        if (trace.valueAxis != axis)
            continue;
        all.include(m_capture.extremes(trace.channel, range.lower, range.upper));
        // A value that only holds into the window is visible too.
        if (const auto held = m_capture.valueAt(trace.channel, range.lower))
            all.include({static_cast<float>(*held), static_cast<float>(*held)});
    }
    return all;
}

double PlotStack::leastSpanOf(const ScopePlot &plot, const ValueAxis &axis) const
{
    double least = 0.0;
    for (const Trace &trace : plot.traces) {
        if (trace.valueAxis != axis.axis)
            continue;
        least = std::max(least, leastSpan(axis.unit, trace.info.digit()));
    }
    return least;
}

/// Of all axes that show a zero; their ranges grow for it, all by the same part at most.
void PlotStack::alignZeros(ScopePlot &plot)
{
    constexpr double kLittle = 0.3; // more of a range
    constexpr double kSame = 1e-6;
    std::vector<QCPAxis *> axes;
    double least = 1.0, most = 0.0; // part of the height that is below zero
    for (const ValueAxis &axis : plot.axes) {
        const QCPRange range = axis.axis->range();
        const bool shows = range.lower < 0.0 && range.upper > 0.0;
        if (!axis.fitted || !(axis.automatic || plot.zerosAligned) || !(shows || plot.zerosAligned))
            continue;
        if (!shows) // it is to: with a little room on its other side
            axis.axis->setRange(roomy(std::min(range.lower, 0.0), std::max(range.upper, 0.0), 0.0));
        const double below = -axis.axis->range().lower / axis.axis->range().size();
        least = std::min(least, below);
        most = std::max(most, below);
        axes.push_back(axis.axis);
    }
    const double more = most - least;
    if (axes.size() < 2 || more < kSame || (more > kLittle && !plot.zerosAligned))
        return;
    const double place = most / (1.0 + more);
    for (QCPAxis *axis : axes) {
        const QCPRange range = axis->range();
        if (-range.lower / range.size() < place)
            axis->setRangeLower(-range.upper * place / (1.0 - place));
        else
            axis->setRangeUpper(-range.lower * (1.0 - place) / place);
    }
}

void PlotStack::setZerosAligned(int plot, bool aligned)
{
    ScopePlot &one = this->plot(plot);
    one.zerosAligned = aligned;
    if (!aligned)
        for (ValueAxis &axis : one.axes)
            fitAxis(axis);
    alignZeros(one);
}

void PlotStack::growAxes()
{
    for (const auto &plot : m_plots) {
        bool grown = false;
        for (ValueAxis &axis : plot->axes) {
            if (!axis.automatic)
                continue;
            const capture::MinMax shown = extremes(*plot, axis.axis);
            if (shown.empty())
                continue;
            const double low = double(shown.min);
            const double high = double(shown.max);
            QCPRange range = axis.axis->range();
            if (!axis.fitted || low < range.lower || high > range.upper) {
                const QCPRange wanted = roomy(low, high, leastSpanOf(*plot, axis));
                if (axis.fitted)
                    range.expand(wanted);
                else
                    range = wanted;
                axis.axis->setRange(range);
                axis.fitted = grown = true;
            }
        }
        if (grown)
            alignZeros(*plot);
    }
}

QMap<QString, ValueRange> PlotStack::heldRanges() const
{
    QMap<QString, ValueRange> held = m_held;
    for (const auto &plot : m_plots)
        for (const ValueAxis &axis : plot->axes) {
            const auto on = std::find_if(plot->traces.begin(), plot->traces.end(),
                [&axis](const Trace &trace) { return trace.valueAxis == axis.axis; });
            if (!axis.automatic && on != plot->traces.end())
                held[QString::fromStdString(on->info.name)] = {
                    axis.axis->range().lower, axis.axis->range().upper};
        }
    return held;
}

void PlotStack::setHeldRanges(const QMap<QString, ValueRange> &ranges)
{
    m_held = ranges;
    for (const auto &plot : m_plots)
        for (ValueAxis &axis : plot->axes) {
            if (!axis.automatic)
                axis.fitted = false;
            axis.automatic = true;
            for (const Trace &trace : plot->traces)
                if (trace.valueAxis == axis.axis)
                    adoptHeldRange(trace, axis);
        }
}

void PlotStack::adoptHeldRange(const Trace &trace, ValueAxis &axis)
{
    const auto held = m_held.find(QString::fromStdString(trace.info.name));
    if (held == m_held.end())
        return;
    axis.axis->setRange(held->from, held->to);
    axis.automatic = false;
    axis.fitted = true;
    m_held.erase(held);
}

void PlotStack::fitAxis(ValueAxis &axis)
{
    for (const auto &plot : m_plots) {
        const capture::MinMax shown = extremes(*plot, axis.axis);
        if (!shown.empty()) {
            axis.axis->setRange(
                roomy(double(shown.min), double(shown.max), leastSpanOf(*plot, axis)));
            axis.fitted = true;
        }
    }
    axis.automatic = true;
}

void PlotStack::fitValues()
{
    for (const auto &plot : m_plots) {
        for (ValueAxis &axis : plot->axes)
            fitAxis(axis);
        alignZeros(*plot);
    }
}

} // namespace widgets
