#include "widgets/scope/hover.h"

#include "widgets/base/device_text.h"
#include "widgets/base/reading_text.h"
#include "widgets/base/trace_colors.h"
#include "widgets/scope/plot_stack.h"
#include "widgets/scope/view.h"

#include <QPainter>

#include <algorithm>

namespace widgets {
namespace {
constexpr int kMostRows = 12;
constexpr int kRoom = 5; ///< pixels around the text
constexpr int kBeside = 14; ///< pixels from the mouse
constexpr int kSwatch = 8;
constexpr int kGroundAlpha = 225, kLineAlpha = 110;

struct Row {
    QColor color;
    QString name, value;
};
} // namespace

ScopeHover::ScopeHover(
    const ScopeView &view, const PlotStack &stack, const capture::Capture &capture, QWidget &plot)
    : QWidget(&plot)
    , m_view(view)
    , m_stack(stack)
    , m_capture(capture)
{
    setObjectName(QStringLiteral("scopeHover"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void ScopeHover::showAt(std::optional<QPointF> position)
{
    const int plot = position ? m_stack.plotAt(*position) : -1;
    const bool inside = plot >= 0 && !m_stack.plot(plot).traces.empty()
        && m_stack.plot(plot).rect->rect().contains(position->toPoint());
    m_position = inside ? position : std::nullopt;
    if (inside)
        setGeometry(parentWidget()->rect());
    setVisible(inside);
    update();
}

void ScopeHover::follow()
{
    if (m_position)
        showAt(m_position);
}

void ScopeHover::paintEvent(QPaintEvent *)
{
    if (!m_position)
        return;
    const int index = m_stack.plotAt(*m_position);
    if (index < 0)
        return;
    const ScopePlot &plot = m_stack.plot(index);
    const double seconds = m_view.time().timeAt(m_position->x());
    const QLocale locale = m_view.locale();
    std::vector<Row> rows;
    for (const Trace &trace : plot.traces) {
        if (rows.size() >= kMostRows)
            break;
        rows.push_back({traceColor(trace.colorSlot, plot.dark), deviceText(trace.info.name),
            readingText(m_capture.valueAt(trace.channel, seconds),
                m_view.readingStepOf(trace.channel), QString::fromStdString(trace.info.unit),
                locale)});
    }
    const QString time = exactTime(seconds - m_view.time().origin(), locale);
    const QFontMetrics metrics = fontMetrics();
    int names = 0, values = 0;
    for (const Row &row : rows) {
        names = std::max(names, metrics.horizontalAdvance(row.name));
        values = std::max(values, metrics.horizontalAdvance(row.value));
    }
    const int text = kSwatch + kRoom + names + 2 * kRoom + values;
    QRectF box(0, 0, std::max(text, metrics.horizontalAdvance(time)) + 2 * kRoom,
        metrics.height() * (int(rows.size()) + 1) + 2 * kRoom);
    // Beside the mouse, on the side where there is room.
    const QPointF at = *m_position;
    const QRectF area = rect();
    box.moveLeft(at.x() + kBeside + box.width() < area.right() ? at.x() + kBeside
                                                               : at.x() - kBeside - box.width());
    box.moveTop(std::min(at.y() + kBeside, area.bottom() - box.height()));

    QPainter painter(this);
    QColor line = palette().color(QPalette::Text);
    line.setAlpha(kLineAlpha);
    painter.setPen(QPen(line, 1, Qt::DotLine));
    for (int i = 0; i < m_stack.count(); ++i) {
        const QRect each = m_stack.plot(i).rect->rect();
        painter.drawLine(QPointF(at.x(), each.top()), QPointF(at.x(), each.bottom()));
    }
    QColor ground = palette().color(QPalette::Base);
    ground.setAlpha(kGroundAlpha);
    painter.setPen(line);
    painter.setBrush(ground);
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(palette().color(QPalette::Text));
    QRectF row = box.adjusted(kRoom, kRoom, -kRoom, 0);
    row.setHeight(metrics.height());
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, time);
    for (const Row &one : rows) {
        row.translate(0, metrics.height());
        painter.fillRect(
            QRectF(row.left(), row.center().y() - kSwatch / 2.0, kSwatch, kSwatch), one.color);
        painter.drawText(
            row.adjusted(kSwatch + kRoom, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, one.name);
        painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, one.value);
    }
}

} // namespace widgets
