#include "widgets/scope/plot_stack.h"

#include "widgets/base/axis_ticks.h"
#include "widgets/base/plot_look.h"
#include "widgets/base/trace_colors.h"
#include "widgets/base/value_text.h"
#include "widgets/scope/drawing/axis_ticker.h"
#include "widgets/scope/drawing/waveform_plottable.h"
#include "widgets/scope/trace_legend.h"

#include <QSet>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

namespace widgets {

namespace {
constexpr int kTimeLabelWidth = 76; ///< pixels
constexpr int kValueLabelHeight = 26;
constexpr int kLowestLabel = 17; ///< pixels, where there is little room
constexpr int kMostTicks = 10;
constexpr int kAboveLegend = 4;
constexpr int kOldBeats = 12;
constexpr qsizetype kMostChosen = 500; ///< colours that are remembered
} // namespace

PlotStack::PlotStack(QCustomPlot &plot, const capture::Capture &capture)
    : m_plot(plot)
    , m_capture(capture)
    , m_margins(new QCPMarginGroup(&plot))
    , m_palette(plot.palette())
{
    m_plot.plotLayout()->clear(); // the axis rect every QCustomPlot starts with
    m_plot.plotLayout()->setRowSpacing(0);
    insert(0);
}

PlotStack::~PlotStack() = default;

ScopePlot &PlotStack::insert(int index)
{
    auto plot = std::make_unique<ScopePlot>();
    plot->rect = new QCPAxisRect(&m_plot, false);
    plot->rect->setMinimumMargins(margins());
    plot->rect->setMarginGroup(QCP::msLeft | QCP::msRight, m_margins);
    plot->dark = isDark(m_palette);
    QCPAxis *time = plot->rect->addAxis(QCPAxis::atBottom);
    auto ticker = QSharedPointer<AxisTicker>::create(AxisTicker::Labels::Times);
    ticker->setOrigin(m_origin);
    time->setTicker(ticker);
    styleAxis(*time);
    m_plot.plotLayout()->insertRow(index);
    m_plot.plotLayout()->addElement(index, 0, plot->rect);
    axisFor(*plot, QString());
    if (!m_plots.empty())
        time->setRange(m_plots.front()->timeAxis()->range());
    plot->waveform = new WaveformPlottable(*plot, m_capture);
    plot->legend = new TraceLegend(*plot, m_capture);
    ScopePlot &inserted = **m_plots.insert(m_plots.begin() + index, std::move(plot));
    showTimeLabels();
    return inserted;
}

QMargins PlotStack::margins() const
{
    return {m_leastLeft, 6, 30, 6}; // right: half a time label
}

void PlotStack::setLeastLeft(int pixels)
{
    m_leastLeft = pixels;
    for (const auto &plot : m_plots)
        makeRoom(*plot);
}

void PlotStack::removePlot(std::size_t index)
{
    ScopePlot &plot = *m_plots[index];
    m_plot.removePlottable(plot.waveform);
    delete plot.legend;
    m_plot.plotLayout()->remove(plot.rect);
    m_plot.plotLayout()->simplify();
    m_plots.erase(m_plots.begin() + static_cast<std::ptrdiff_t>(index));
    showTimeLabels();
}

/// Only the lowest plot needs them: the axis is the same for all.
void PlotStack::showTimeLabels()
{
    for (std::size_t i = 0; i < m_plots.size(); ++i)
        m_plots[i]->timeAxis()->setTickLabels(i + 1 == m_plots.size());
}

int PlotStack::plotAt(const QPointF &position) const
{
    for (int i = 0; i < count(); ++i) {
        if (plot(i).rect->outerRect().contains(position.toPoint()))
            return i;
    }
    return -1;
}

ValueAxis *PlotStack::valueAxisAt(const QPointF &position)
{
    for (const auto &plot : m_plots) {
        for (ValueAxis &axis : plot->axes) {
            if (axis.axis->visible() && axis.axis->getPartAt(position) != QCPAxis::spNone)
                return &axis;
        }
    }
    return nullptr;
}

ValueAxis &PlotStack::axisFor(ScopePlot &plot, const QString &unit)
{
    for (ValueAxis &axis : plot.axes) {
        if (axis.unit == unit)
            return axis;
    }
    if (plot.traces.empty() && !plot.axes.empty()) {
        plot.axes.front().unit = unit; // the axis of an empty plot takes the first unit that comes
        plot.axes.front().automatic = true;
        plot.axes.front().fitted = false;
        return plot.axes.front();
    }
    if (int(plot.axes.size()) >= kMostAxes)
        return plot.axes.back();
    const bool left = plot.axes.size() % 2 == 0;
    QCPAxis *axis = plot.rect->addAxis(left ? QCPAxis::atLeft : QCPAxis::atRight);
    axis->setTicker(QSharedPointer<AxisTicker>::create(AxisTicker::Labels::Values));
    axis->setRange(-1, 1);
    styleAxis(*axis);
    // One grid a plot: that of its first axis.
    axis->grid()->setVisible(plot.axes.empty() && m_grid);
    plot.axes.push_back({axis, unit});
    return plot.axes.back();
}

void PlotStack::dropUnusedAxes(ScopePlot &plot)
{
    const auto isUsed = [&plot](const ValueAxis &axis) {
        return std::any_of(plot.traces.begin(), plot.traces.end(),
            [&axis](const Trace &trace) { return trace.valueAxis == axis.axis; });
    };
    // The first axis stays: the grid and the waveform belong to it. Where its unit is gone it takes the next one.
    const auto heir = std::find_if(plot.axes.begin(), plot.axes.end(), isUsed);
    if (heir != plot.axes.end() && heir != plot.axes.begin()) {
        ValueAxis &front = plot.axes.front();
        for (Trace &trace : plot.traces)
            if (trace.valueAxis == heir->axis)
                trace.valueAxis = front.axis;
        front.axis->setRange(heir->axis->range());
        front.unit = heir->unit;
        front.automatic = heir->automatic;
        front.fitted = heir->fitted;
    }
    for (std::size_t i = plot.axes.size(); i-- > 1;) {
        if (!isUsed(plot.axes[i])) {
            plot.rect->removeAxis(plot.axes[i].axis);
            plot.axes.erase(plot.axes.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
}

void PlotStack::labelAxes(ScopePlot &plot)
{
    for (const ValueAxis &axis : plot.axes) {
        const Trace *only = nullptr;
        int users = 0;
        for (const Trace &trace : plot.traces) {
            if (trace.valueAxis == axis.axis) {
                only = &trace;
                ++users;
            }
        }
        labelAxis(plot, axis);
        const QColor color =
            users == 1 ? traceColor(only->colorSlot, plot.dark) : m_palette.color(QPalette::Text);
        colorAxis(*axis.axis, color);
    }
}

int PlotStack::slotFor(const capture::ChannelInfo &channel)
{
    const auto chosen = m_chosen.constFind(QString::fromStdString(channel.name));
    if (chosen != m_chosen.constEnd())
        return *chosen;
    const auto known = m_slots.find(channel.registerId);
    if (known != m_slots.end())
        return known->second;
    std::array<int, kTraceColors> uses{};
    for (const Trace *trace : traces())
        if (trace->info.registerId != channel.registerId) // not its own, which it is to lose
            ++uses[std::size_t(trace->colorSlot)];
    // The first free one of its family's; where none is free, one that the fewest have.
    const int preferred = preferredSlot(QString::fromStdString(channel.unit));
    int slot = preferred;
    for (int next = preferred; next < preferred + kTraceColors; ++next) {
        if (uses[std::size_t(next % kTraceColors)] < uses[std::size_t(slot)])
            slot = next % kTraceColors;
    }
    m_slots[channel.registerId] = slot;
    return slot;
}

void PlotStack::add(const capture::ChannelInfo &channel, int index, bool alone)
{
    if (plotOf(channel.id) >= 0)
        return;
    const bool onlyEmptyOne = count() == 1 && plot(0).traces.empty();
    index = std::clamp(index, 0, onlyEmptyOne ? 0 : count());
    alone = (alone && !onlyEmptyOne) || index == count();
    ScopePlot &target = alone ? insert(index) : plot(index);
    const int slot = slotFor(channel);
    ValueAxis &axis = axisFor(target, QString::fromStdString(channel.unit));
    target.traces.push_back({channel.id, channel, axis.axis, slot, false});
    adoptHeldRange(target.traces.back(), axis);
    labelAxes(target);
}

void PlotStack::remove(capture::ChannelId channel)
{
    const int index = plotOf(channel);
    if (index < 0)
        return;
    ScopePlot &from = plot(index);
    std::erase_if(from.traces, [channel](const Trace &trace) { return trace.channel == channel; });
    if (from.traces.empty() && count() > 1) {
        removePlot(std::size_t(index));
        return;
    }
    dropUnusedAxes(from);
    labelAxes(from);
}

bool PlotStack::move(capture::ChannelId channel, int index)
{
    const int from = plotOf(channel);
    index = std::clamp(index, 0, count());
    const bool alone = from >= 0 && plot(from).traces.size() == 1;
    if (from < 0 || from == index || (alone && index == count()))
        return false;
    const Trace moved = *trace(channel);
    remove(channel);
    add(moved.info, alone && from < index ? index - 1 : index);
    if (moved.selected)
        select(channel);
    return true;
}

std::vector<Trace *> PlotStack::traces() const
{
    std::vector<Trace *> all;
    for (const auto &plot : m_plots)
        for (Trace &trace : plot->traces)
            all.push_back(&trace);
    return all;
}

const Trace *PlotStack::trace(capture::ChannelId channel) const
{
    for (const Trace *trace : traces())
        if (trace->channel == channel)
            return trace;
    return nullptr;
}

std::vector<capture::ChannelId> PlotStack::channels() const
{
    std::vector<capture::ChannelId> result;
    for (const Trace *trace : traces())
        result.push_back(trace->channel);
    return result;
}

int PlotStack::plotOf(capture::ChannelId channel) const
{
    for (int i = 0; i < count(); ++i) {
        const auto &traces = plot(i).traces;
        if (std::any_of(traces.begin(), traces.end(),
                [channel](const Trace &trace) { return trace.channel == channel; }))
            return i;
    }
    return -1;
}

QColor PlotStack::colorOf(capture::ChannelId channel) const
{
    const Trace *shown = trace(channel);
    return shown ? traceColor(shown->colorSlot, isDark(m_palette)) : QColor();
}

/// One of a signal that is not shown, whose change is not seen; there are more colours than a picture has traces.
void PlotStack::forgetColor()
{
    QSet<QString> shown;
    for (const Trace *trace : traces())
        shown.insert(QString::fromStdString(trace->info.name));
    auto forgotten = m_chosen.begin();
    while (std::next(forgotten) != m_chosen.end() && shown.contains(forgotten.key()))
        ++forgotten;
    m_chosen.erase(forgotten);
}

void PlotStack::setColor(const QString &name, std::optional<int> slot)
{
    m_chosen.remove(name);
    if (slot) {
        while (m_chosen.size() >= kMostChosen)
            forgetColor();
        m_chosen[name] = std::clamp(*slot, 0, kTraceColors - 1);
    }
    for (const auto &plot : m_plots) {
        for (Trace &each : plot->traces)
            if (QString::fromStdString(each.info.name) == name) {
                m_slots.erase(each.info.registerId);
                each.colorSlot = slotFor(each.info);
            }
        labelAxes(*plot);
    }
}

std::optional<double> PlotStack::newestSample() const
{
    std::optional<double> newest;
    for (const capture::ChannelId id : channels()) {
        const capture::Channel *channel = m_capture.channel(id);
        if (!channel || channel->empty())
            continue;
        const double last = capture::toSeconds(channel->timeOf(channel->end() - 1));
        newest = std::max(newest.value_or(last), last);
    }
    return newest;
}

bool PlotStack::adoptChannels()
{
    bool changed = false;
    std::vector<capture::ChannelId> lost;
    for (Trace *trace : traces()) {
        if (m_capture.channel(trace->channel))
            continue;
        changed = true;
        const auto successor = m_capture.find(trace->info.registerId, trace->info.kind);
        if (successor && plotOf(*successor) < 0) {
            trace->channel = *successor;
            trace->info = *m_capture.info(*successor);
        } else {
            lost.push_back(trace->channel);
        }
    }
    for (const capture::ChannelId channel : lost)
        remove(channel);
    return changed;
}

bool isOld(const Trace &trace, const capture::Capture &capture)
{
    const capture::Channel *channel = capture.channel(trace.channel);
    return trace.beats >= kOldBeats && channel && channel->end() == trace.end;
}

bool PlotStack::beat(bool waits)
{
    bool changed = false;
    for (Trace *trace : traces()) {
        const capture::Channel *channel = m_capture.channel(trace->channel);
        const capture::Index end = channel ? channel->end() : 0;
        const bool came = std::exchange(trace->end, end) != end;
        // Behind a closed port the first beat tells: what stood before it is older than any wait.
        trace->beats = came || !trace->info.isBoards() ? 0
            : waits                                    ? trace->beats + 1
                                                       : kOldBeats - 1;
        changed = changed || trace->beats == kOldBeats;
    }
    return changed;
}

void PlotStack::select(std::optional<capture::ChannelId> channel)
{
    for (Trace *trace : traces())
        trace->selected = channel == trace->channel;
}

std::optional<capture::ChannelId> PlotStack::selected() const
{
    for (const Trace *trace : traces())
        if (trace->selected)
            return trace->channel;
    return std::nullopt;
}

void PlotStack::setGhosts(std::vector<Ghost> ghosts)
{
    for (std::size_t i = 1; i < m_plots.size(); ++i)
        m_plots[i]->ghosts = ghosts;
    m_plots.front()->ghosts = std::move(ghosts);
}

void PlotStack::setGrid(bool visible)
{
    m_grid = visible;
    for (const auto &plot : m_plots) {
        plot->timeAxis()->grid()->setVisible(visible);
        plot->axes.front().axis->grid()->setVisible(visible);
    }
}

void PlotStack::styleAxis(QCPAxis &axis) const
{
    dressAxis(axis, m_palette.color(QPalette::Text), m_plot.font());
    axis.setLayer(QStringLiteral("axes"));
    axis.grid()->setVisible(m_grid);
}

void PlotStack::applyPalette(const QPalette &palette)
{
    m_palette = palette;
    m_plot.setBackground(palette.brush(QPalette::Base));
    for (const auto &plot : m_plots) {
        plot->dark = isDark(palette);
        styleAxis(*plot->timeAxis());
        for (std::size_t i = 0; i < plot->axes.size(); ++i) {
            styleAxis(*plot->axes[i].axis);
            plot->axes[i].axis->grid()->setVisible(i == 0 && m_grid);
        }
        labelAxes(*plot);
    }
    renew();
}

int PlotStack::timeTicks() const
{
    return std::clamp(plot(0).rect->width() / kTimeLabelWidth, 2, kMostTicks);
}

int PlotStack::ticksOf(const ScopePlot &plot) const
{
    // Fewer than three say nothing of the scale; where they do not fit, two.
    const int least = plot.rect->height() >= 3 * kLowestLabel ? 3 : 2;
    return std::clamp(plot.rect->height() / kValueLabelHeight, least, kMostTicks);
}

double PlotStack::timeStep() const
{
    return tickStep(plot(0).timeAxis()->range().size(), timeTicks());
}

/// The unit, and before it what a division is worth where there is room to say so and only one unit has to be said.
void PlotStack::labelAxis(const ScopePlot &plot, const ValueAxis &axis) const
{
    std::set<QString> units;
    for (const Trace &trace : plot.traces) {
        if (trace.valueAxis == axis.axis)
            units.insert(unitText(trace.info.unit));
    }
    QString label = QStringList(units.begin(), units.end()).join(QStringLiteral(" / "));
    if (units.size() == 1) {
        const QCPRange range = axis.axis->range();
        const double step =
            valueStep(range.lower, range.upper, ticksOf(plot), plot.rect->height() / kLowestLabel);
        const QString scale = perDivision(step, label, m_plot.locale());
        if (QFontMetrics(m_plot.font()).horizontalAdvance(scale) <= plot.rect->height())
            label = scale;
    }
    axis.axis->setLabel(label);
}

void PlotStack::makeRoom(ScopePlot &plot) const
{
    QMargins least = margins();
    least.setTop(std::max(least.top(), plot.legend->height() + kAboveLegend));
    if (plot.rect->minimumMargins() != least)
        plot.rect->setMinimumMargins(least);
}

void PlotStack::renew()
{
    for (const auto &plot : m_plots)
        plot->waveform->renew();
}

void PlotStack::layOut()
{
    // How many ticks have room is asked of the plots as they are laid out: of a new size they have to be first.
    if (const QRect now = m_plot.viewport(); now != std::exchange(m_laidOut, now)) {
        for (const auto phase : {QCPLayoutElement::upPreparation, QCPLayoutElement::upMargins,
                 QCPLayoutElement::upLayout})
            m_plot.plotLayout()->update(phase);
    }
    plot(0).legend->setNote(timePerDivision(timeStep(), m_plot.locale()));
    for (const auto &plot : m_plots) {
        plot->timeAxis()->ticker().dynamicCast<AxisTicker>()->setMost(
            timeTicks(), plot->rect->width());
        for (const ValueAxis &axis : plot->axes) {
            axis.axis->ticker().dynamicCast<AxisTicker>()->setMost(
                ticksOf(*plot), plot->rect->height(), plot->rect->height() / kLowestLabel);
            labelAxis(*plot, axis);
        }
        makeRoom(*plot);
    }
}

} // namespace widgets
