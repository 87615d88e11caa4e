#include "widgets/scope/trace_legend.h"

#include "widgets/base/axis_ticks.h"
#include "widgets/base/trace_colors.h"
#include "widgets/base/value_text.h"

#include <cmath>

namespace widgets {

namespace {
constexpr double kLegendMark = 10.0; ///< side of the coloured mark
constexpr double kSpace = 6.0;
constexpr double kBelow = 2.0; ///< between the last line and the plot

/// As wide as the longest number that its axis can show, so that entries do not dance while values change.
QString paddedReading(const Trace &trace, std::optional<double> value, const QLocale &locale)
{
    const double step = readingStep(trace);
    const QCPRange range = trace.valueAxis->range();
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    const auto width = valueLabel(-largest, step, locale).size();
    const QString text = value ? valueLabel(*value, step, locale) : QStringLiteral("\u2013");
    // Figure spaces are as wide as digits; a sign is about as wide as one.
    return QString(std::max<qsizetype>(width - text.size(), 0), QChar(0x2007)) + text;
}
} // namespace

double readingStep(const Trace &trace)
{
    // A polled value comes scaled: what its digit is worth is not known here.
    const double digit = std::abs(trace.info.digit());
    // What was computed has as good a value as what it was computed from.
    const int steps = trace.info.isBoards() ? 200 : 2000;
    return digit > 0 ? digit : tickStep(trace.valueAxis->range().size(), steps);
}

TraceLegend::TraceLegend(const ScopePlot &plot, const capture::Capture &capture)
    : QCPLayerable(plot.rect->parentPlot(), QStringLiteral("legend"))
    , m_scopePlot(plot)
    , m_capture(capture)
{
}

std::optional<capture::ChannelId> TraceLegend::channelAt(const QPointF &position) const
{
    for (const auto &[rect, channel] : m_entries) {
        if (rect.contains(position))
            return channel;
    }
    return std::nullopt;
}

void TraceLegend::applyDefaultAntialiasingHint(QCPPainter *painter) const
{
    painter->setAntialiasing(false);
}

double TraceLegend::lineHeight() const { return QFontMetricsF(mParentPlot->font()).height(); }

std::vector<TraceLegend::Entry> TraceLegend::entries() const
{
    std::vector<Entry> all;
    const double width = m_scopePlot.rect->width();
    const double note = QFontMetricsF(mParentPlot->font()).horizontalAdvance(m_note);
    QPointF at(kSpace, 0.0);
    for (const Trace &trace : m_scopePlot.traces) {
        QFont font = mParentPlot->font();
        font.setBold(trace.selected);
        QString text = QString::fromStdString(trace.info.name);
        if (const auto last = m_capture.lastValue(trace.channel))
            text += QStringLiteral("  ")
                + paddedReading(
                    trace, isOld(trace, m_capture) ? std::nullopt : last, mParentPlot->locale());
        if (!trace.info.unit.empty())
            text += QChar(QChar::Nbsp) + unitText(trace.info.unit);
        const double wide = QFontMetricsF(font).horizontalAdvance(text) + kLegendMark + 3 * kSpace;
        const double room = at.y() > 0.0 ? width : width - note;
        if (at.x() > kSpace && at.x() + wide > room)
            at = {kSpace, at.y() + lineHeight()};
        all.push_back({&trace, text, QRectF(at, QSizeF(wide, lineHeight()))});
        at.rx() += wide + kSpace;
    }
    return all;
}

int TraceLegend::height() const
{
    const auto all = entries();
    return all.empty() ? 0 : static_cast<int>(std::ceil(all.back().box.bottom()));
}

void TraceLegend::draw(QCPPainter *painter)
{
    m_entries.clear();
    const QPalette palette = mParentPlot->palette();
    const auto all = entries();
    if (all.empty())
        return;
    const QRectF area = m_scopePlot.rect->rect();
    const QPointF corner(area.left(), area.top() - kBelow - all.back().box.bottom());
    painter->setFont(mParentPlot->font());
    painter->setPen(palette.color(QPalette::Text));
    painter->drawText(QRectF(corner, QSizeF(area.width(), lineHeight())),
        Qt::AlignRight | Qt::AlignVCenter | Qt::TextSingleLine, m_note);
    for (const Entry &entry : all) {
        const QRectF box = entry.box.translated(corner);
        const bool selected = entry.trace->selected;
        if (selected) {
            QColor ground = palette.color(QPalette::Highlight);
            ground.setAlpha(90);
            painter->fillRect(box, ground);
        }
        painter->fillRect(QRectF(box.x() + kSpace / 2, box.center().y() - kLegendMark / 2,
                              kLegendMark, kLegendMark),
            traceColor(entry.trace->colorSlot, m_scopePlot.dark));
        QFont font = mParentPlot->font();
        font.setBold(selected);
        painter->setFont(font);
        painter->setPen(palette.color(QPalette::Text));
        // drawText takes the name as it is: a device's text is never rich text here.
        painter->drawText(box.adjusted(kLegendMark + kSpace + kSpace / 2, 0, 0, 0),
            Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, entry.text);
        m_entries.emplace_back(box, entry.trace->channel);
    }
}

} // namespace widgets
