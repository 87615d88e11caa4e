// How the scope's overlay draws what a measurement measured: levels, bands and the ends of what was timed.
#include "widgets/base/trace_colors.h"
#include "widgets/scope/overlay.h"
#include "widgets/scope/plot_stack.h"

#include <QPainter>

namespace widgets {

namespace {
constexpr int kBandAlpha = 30;
constexpr double kPoint = 4.5; ///< half the side of a point's cross

} // namespace

void ScopeOverlay::setMeasure(const MeasureMarks &marks)
{
    if (marks.empty() && m_measure.empty())
        return;
    m_measure = marks;
    follow();
}

void ScopeOverlay::paintMeasure(QPainter &painter) const
{
    const Trace *trace = m_stack.trace(m_measure.channel);
    if (!trace)
        return;
    const ScopePlot &plot = m_stack.plot(m_stack.plotOf(m_measure.channel));
    const QRectF area = plot.rect->rect();
    const QColor ink = palette().color(QPalette::Text);
    const auto yOf = [&](double level) { return trace->valueAxis->coordToPixel(level); };
    const auto at = [this](scope::Nanos time) { return xOf(capture::toSeconds(time)); };
    painter.save();
    painter.setClipRect(area);
    std::optional<QRectF> band;
    for (const scope::LevelMark &mark : m_measure.levels) {
        using Role = scope::LevelMark::Role;
        const QLineF line(at(mark.from), yOf(mark.level), at(mark.to), yOf(mark.level));
        const bool measured = mark.role == Role::Measured;
        QPen pen(measured ? ink : faded(ink, kReferenceAlpha), measured ? 1.5 : 1.0);
        if (!measured)
            pen.setDashPattern({4, 3});
        painter.setPen(pen);
        painter.drawLine(line);
        if (mark.role == Role::BandLow || mark.role == Role::BandHigh) {
            const QRectF edge(line.p1(), line.p2());
            if (band)
                painter.fillRect(band->united(edge.adjusted(0, -0.01, 0, 0.01)),
                    faded(traceColor(trace->colorSlot, plot.dark), kBandAlpha));
            else
                band = edge.adjusted(0, -0.01, 0, 0.01);
        }
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(ink, 1.5));
    for (const scope::PointMark &mark : m_measure.points) {
        const QPointF point(at(mark.time), yOf(mark.level));
        painter.drawLine(point + QPointF(-kPoint, -kPoint), point + QPointF(kPoint, kPoint));
        painter.drawLine(point + QPointF(-kPoint, kPoint), point + QPointF(kPoint, -kPoint));
        painter.setPen(QPen(faded(ink, kReferenceAlpha), 1, Qt::DotLine));
        painter.drawLine(QPointF(point.x(), area.top()), QPointF(point.x(), area.bottom()));
        painter.setPen(QPen(ink, 1.5));
    }
    // Below the legend, so that both can be read.
    const QFontMetricsF metrics(font());
    const double width = metrics.horizontalAdvance(m_measure.text) + 8;
    const QRectF box(
        area.left() + 6, area.bottom() - 2 * metrics.height() - 4, width, metrics.height());
    painter.fillRect(box, faded(palette().color(QPalette::Base), 210));
    painter.setFont(font());
    painter.drawText(box, Qt::AlignCenter | Qt::TextSingleLine, m_measure.text);
    painter.restore();
}

} // namespace widgets
