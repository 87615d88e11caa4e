#include "widgets/scope/trace_legend.h"

#include "widgets/scope/axis_ticks.h"
#include "widgets/scope/trace_colors.h"

namespace widgets {

namespace {
constexpr double kMark = 10.0; ///< side of the coloured mark
constexpr double kSpace = 6.0;

/// As wide as the longest number that its axis can show, so that entries do not dance while values change.
QString paddedReading(const Trace &trace, double value, const QLocale &locale)
{
    const double step = readingStep(trace);
    const QCPRange range = trace.valueAxis->range();
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    const auto width = valueLabel(-largest, step, locale).size();
    const QString text = valueLabel(value, step, locale);
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

void TraceLegend::draw(QCPPainter *painter)
{
    m_entries.clear();
    const QRectF area = m_scopePlot.rect->rect();
    const QPalette palette = mParentPlot->palette();
    const double lineHeight = QFontMetricsF(mParentPlot->font()).height();
    QPointF at = area.topLeft() + QPointF(kSpace, kSpace / 2);
    for (const Trace &trace : m_scopePlot.traces) {
        QFont font = mParentPlot->font();
        font.setBold(trace.selected);
        QString text = QString::fromStdString(trace.info.name);
        if (const auto value = m_capture.lastValue(trace.channel))
            text += QStringLiteral("  ") + paddedReading(trace, *value, mParentPlot->locale());
        if (!trace.info.unit.empty())
            text += QChar(QChar::Nbsp) + QString::fromStdString(trace.info.unit);
        const double width = QFontMetricsF(font).horizontalAdvance(text) + kMark + 3 * kSpace;
        if (at.x() > area.left() + kSpace && at.x() + width > area.right())
            at = {area.left() + kSpace, at.y() + lineHeight};
        const QRectF box(at, QSizeF(width, lineHeight));
        QColor ground = palette.color(trace.selected ? QPalette::Highlight : QPalette::Base);
        ground.setAlpha(trace.selected ? 90 : 190);
        painter->fillRect(box, ground);
        painter->fillRect(
            QRectF(at.x() + kSpace / 2, at.y() + (lineHeight - kMark) / 2, kMark, kMark),
            traceColor(trace.colorSlot, m_scopePlot.dark));
        painter->setFont(font);
        painter->setPen(palette.color(QPalette::Text));
        // drawText takes the name as it is: a device's text is never rich text here.
        painter->drawText(box.adjusted(kMark + kSpace + kSpace / 2, 0, 0, 0),
            Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, text);
        m_entries.emplace_back(box, trace.channel);
        at.rx() += width + kSpace;
    }
}

} // namespace widgets
