#include "widgets/scope/overview.h"

#include "widgets/scope/view.h"

#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace widgets {

namespace {
constexpr int kHeight = 34;
constexpr double kEdge = 5.0; ///< pixels around an edge that take it
constexpr double kLeastBox = 6.0;
constexpr qint64 kReadEveryMs = 250;
constexpr double kKeyStep = 0.5; ///< of what is seen
} // namespace

ScopeOverview::ScopeOverview(ScopeView &scope, const capture::Capture &capture, QWidget *parent)
    : QWidget(parent)
    , m_scope(scope)
    , m_capture(capture)
{
    setObjectName(QStringLiteral("scopeOverview"));
    setAccessibleName(tr("Whole recording"));
    setToolTip(tr("The whole recording; the box is what the plots show. Drag it or its edges."));
    setFocusPolicy(Qt::TabFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setVisible(false);
    connect(&scope, &ScopeView::drawn, this, [this] {
        if (isVisible()) {
            readColumns();
            update();
        }
    });
}

QSize ScopeOverview::sizeHint() const { return {200, kHeight}; }

/// The selected trace, or the first one, over everything that was recorded of what is shown.
void ScopeOverview::readColumns()
{
    const QList<capture::ChannelId> shown = m_scope.channels();
    const auto wanted = m_scope.selectedChannel().value_or(shown.isEmpty() ? 0 : shown.first());
    const bool fresh = m_read.isValid() && m_read.elapsed() < kReadEveryMs;
    if (fresh && wanted == m_channel && m_columns.size() == std::size_t(std::max(width(), 1)))
        return;
    m_read.start();
    m_channel = wanted;
    m_span = m_capture.timeSpan(wanted);
    m_columns.clear();
    if (m_span && m_span->to > m_span->from && width() > 0)
        m_columns = m_capture.columns(wanted, m_span->from, m_span->to, std::size_t(width()));
}

double ScopeOverview::timeAt(double x) const
{
    return m_span ? m_span->from + x / std::max(1, width()) * (m_span->to - m_span->from) : 0.0;
}

double ScopeOverview::xOf(double seconds) const
{
    return (seconds - m_span->from) / (m_span->to - m_span->from) * width();
}

QRectF ScopeOverview::box() const
{
    if (!m_span || !(m_span->to > m_span->from))
        return {};
    const ScopeView::TimeRange seen = m_scope.visibleRange();
    double left = std::clamp(xOf(seen.from), 0.0, double(width()));
    double right = std::clamp(xOf(seen.to), 0.0, double(width()));
    if (right - left < kLeastBox) {
        const double middle =
            std::clamp((left + right) / 2, kLeastBox / 2, width() - kLeastBox / 2);
        left = middle - kLeastBox / 2;
        right = middle + kLeastBox / 2;
    }
    return {left, 0.5, right - left, height() - 1.0};
}

void ScopeOverview::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    capture::MinMax all;
    for (const capture::MinMax &column : m_columns)
        all.include(column);
    if (!all.empty()) {
        const double low = double(all.min);
        const double span = std::max(double(all.max) - low, 1e-12);
        const double room = height() - 7.0;
        painter.setPen(m_scope.colorOf(m_channel));
        for (std::size_t x = 0; x < m_columns.size(); ++x) {
            if (m_columns[x].empty())
                continue;
            const double top = 3.0 + (1.0 - (double(m_columns[x].max) - low) / span) * room;
            const double bottom = 3.0 + (1.0 - (double(m_columns[x].min) - low) / span) * room;
            painter.drawLine(
                QPointF(double(x), top), QPointF(double(x), std::max(bottom, top + 0.5)));
        }
    }
    const QRectF seen = box();
    QColor veil = palette().color(QPalette::Window);
    veil.setAlpha(170);
    painter.fillRect(QRectF(0, 0, seen.left(), height()), veil);
    painter.fillRect(QRectF(seen.right(), 0, width() - seen.right(), height()), veil);
    painter.setPen(QPen(palette().color(QPalette::Highlight), hasFocus() ? 2 : 1));
    painter.drawRect(seen.adjusted(0, 0, -1, -1));
}

ScopeOverview::Part ScopeOverview::partAt(double x) const
{
    const QRectF seen = box();
    if (std::abs(x - seen.left()) <= kEdge && seen.width() > 3 * kEdge)
        return Part::Left;
    if (std::abs(x - seen.right()) <= kEdge && seen.width() > 3 * kEdge)
        return Part::Right;
    return x >= seen.left() && x <= seen.right() ? Part::Box : Part::None;
}

void ScopeOverview::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || !m_span)
        return;
    setFocus(Qt::MouseFocusReason);
    const double time = timeAt(event->position().x());
    m_held = partAt(event->position().x());
    if (m_held == Part::None) { // the picture comes to the mouse
        m_scope.time().centerOn(time);
        m_held = Part::Box;
    }
    m_grip = time - m_scope.visibleRange().from;
}

void ScopeOverview::mouseMoveEvent(QMouseEvent *event)
{
    const double x = event->position().x();
    if (m_held == Part::None) {
        const Part part = partAt(x);
        setCursor(part == Part::Left || part == Part::Right ? Qt::SizeHorCursor : Qt::ArrowCursor);
        return;
    }
    const double time = timeAt(x);
    const ScopeView::TimeRange seen = m_scope.visibleRange();
    if (m_held == Part::Box)
        m_scope.setVisibleRange(time - m_grip, time - m_grip + (seen.to - seen.from));
    else if (m_held == Part::Left && time < seen.to)
        m_scope.setVisibleRange(time, seen.to);
    else if (m_held == Part::Right && time > seen.from)
        m_scope.setVisibleRange(seen.from, time);
    update();
}

void ScopeOverview::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Left:
        m_scope.time().pan(-kKeyStep);
        return;
    case Qt::Key_Right:
        m_scope.time().pan(kKeyStep);
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace widgets
