#include "widgets/scope/mouse.h"

#include "widgets/base/axis_ticks.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/drop.h"
#include "widgets/scope/plot_stack.h"
#include "widgets/scope/trace_legend.h"
#include "widgets/scope/view.h"

#include <QMouseEvent>
#include <QRubberBand>
#include <QWheelEvent>

#include <cmath>

namespace widgets {

namespace {
constexpr int kClick = 5; ///< pixels a hand may shake during a click
constexpr double kWheelNotch = 120.0;
constexpr double kDivisions = 8.0; ///< of a value axis
constexpr double kZoomPerNotch = 1.25;

double fractionIn(double position, double start, double length)
{
    return length > 0 ? (position - start) / length : 0.5;
}
} // namespace

ScopeMouse::ScopeMouse(ScopeView &view, QCustomPlot &plot, PlotStack &stack, ScopeDrop &drop)
    : QObject(&view)
    , m_view(view)
    , m_plot(plot)
    , m_stack(stack)
    , m_drop(drop)
    , m_handles(view, stack)
    , m_box(new QRubberBand(QRubberBand::Rectangle, &plot))
{
    plot.installEventFilter(this);
}

bool ScopeMouse::eventFilter(QObject *, QEvent *event)
{
    switch (event->type()) {
    case QEvent::MouseButtonDblClick:
        if (markTime(*static_cast<QMouseEvent *>(event)))
            return true;
        [[fallthrough]]; // two quick clicks are two clicks
    case QEvent::MouseButtonPress:
        return press(*static_cast<QMouseEvent *>(event));
    case QEvent::MouseMove:
        return move(*static_cast<QMouseEvent *>(event));
    case QEvent::MouseButtonRelease:
        return release(*static_cast<QMouseEvent *>(event));
    case QEvent::Wheel:
        return wheel(*static_cast<QWheelEvent *>(event));
    case QEvent::Leave:
        m_position.reset();
        Q_EMIT hovered({});
        return false;
    default:
        return false;
    }
}

bool ScopeMouse::press(const QMouseEvent &event)
{
    Q_EMIT hovered({});
    m_view.setFocus(Qt::MouseFocusReason);
    m_start = event.position();
    m_plotIndex = m_stack.plotAt(m_start);
    if (m_plotIndex < 0)
        return true;
    ValueAxis *axis = m_stack.valueAxisAt(m_start);
    if (event.button() == Qt::MiddleButton) {
        if (axis)
            m_stack.fitAxis(*axis);
        else
            m_stack.fitValues();
        m_view.redraw();
    } else if (event.button() == Qt::RightButton) {
        m_gesture = Gesture::Box;
    } else if (event.button() == Qt::LeftButton && takeHandle()) {
        return true;
    } else if (event.button() == Qt::LeftButton && axis) {
        m_gesture = Gesture::MoveAxis;
        m_axis = axis->axis;
        m_from = axis->axis->range().lower;
        m_to = axis->axis->range().upper;
        axis->automatic = false;
    } else if (event.button() == Qt::LeftButton) {
        pressLeft();
    }
    return true;
}

/// A double click on the time axis sets a marker there.
bool ScopeMouse::markTime(const QMouseEvent &event)
{
    const QRect last = m_stack.plot(m_stack.count() - 1).rect->rect();
    const QPointF at = event.position();
    if (event.button() != Qt::LeftButton || at.y() <= last.bottom() || at.x() < last.left()
        || at.x() > last.right())
        return false;
    m_view.cursorActions().setMarkerAt(m_view.time().timeAt(at.x()));
    return true;
}

/// True if the press was for a cursor or the trigger.
bool ScopeMouse::takeHandle()
{
    if (m_attached) { // the click that lets the cursor stay where it is
        m_attached.reset();
        return true;
    }
    m_handle = m_handles.at(m_start);
    if (!m_handle)
        return false;
    m_gesture = Gesture::MoveHandle;
    m_handles.accept(*m_handle);
    return true;
}

void ScopeMouse::pressLeft()
{
    const auto channel = m_stack.plot(m_plotIndex).legend->channelAt(m_start);
    m_stack.select(channel);
    m_view.redraw();
    if (channel) {
        m_gesture = Gesture::MoveTrace;
        m_trace = channel;
        return;
    }
    m_view.cursors().setActive({});
    m_gesture = Gesture::Pan;
    m_from = m_view.visibleRange().from;
    m_to = m_view.visibleRange().to;
}

/// Nothing is pressed: an attached cursor comes along, and the pointer says what could be taken.
void ScopeMouse::hover(const QPointF &position)
{
    if (m_attached) {
        m_view.cursors().move(*m_attached, m_view.time().timeAt(position.x()));
        Q_EMIT hovered({});
        return;
    }
    const auto handle = m_handles.at(position);
    Q_EMIT hovered(handle ? std::nullopt : std::optional(position));
    if (handle)
        m_plot.setCursor(m_handles.shape(*handle));
    else
        m_plot.unsetCursor();
}

bool ScopeMouse::move(const QMouseEvent &event)
{
    const QPointF moved = event.position() - m_start;
    m_position = event.position();
    if (m_gesture == Gesture::None)
        hover(event.position());
    else if (m_gesture == Gesture::MoveHandle)
        m_handles.move(*m_handle, event.position());
    if (m_gesture == Gesture::Pan && std::abs(moved.x()) >= 1) {
        const double width = m_stack.plot(0).rect->width();
        const double shift = moved.x() / std::max(width, 1.0) * (m_to - m_from);
        m_view.setVisibleRange(m_from - shift, m_to - shift);
    } else if (m_gesture == Gesture::MoveAxis && m_axis) { // it may have gone with its last trace
        auto *axis = static_cast<QCPAxis *>(m_axis.data());
        const double height = axis->axisRect()->height();
        const double shift = moved.y() / std::max(height, 1.0) * (m_to - m_from);
        axis->setRange(m_from + shift, m_to + shift);
        m_view.redraw();
    } else if (m_gesture == Gesture::MoveTrace && moved.manhattanLength() > 2 * kClick) {
        m_drop.markTrace(m_plot.mapTo(&m_view, event.position().toPoint()));
    } else if (m_gesture == Gesture::Box && moved.manhattanLength() > kClick) {
        m_box->setGeometry(QRect(m_start.toPoint(), event.position().toPoint()).normalized());
        m_box->show();
    }
    return true;
}

bool ScopeMouse::release(const QMouseEvent &event)
{
    const Gesture gesture = std::exchange(m_gesture, Gesture::None);
    const double moved = (event.position() - m_start).manhattanLength();
    if (gesture == Gesture::MoveTrace && moved > 2 * kClick)
        m_drop.dropTrace(*m_trace, m_plot.mapTo(&m_view, event.position().toPoint()));
    else if (gesture == Gesture::MoveTrace)
        m_drop.hideMark(); // it was brought back
    if (gesture == Gesture::Box) {
        m_box->hide();
        const QRect box = QRect(m_start.toPoint(), event.position().toPoint()).normalized();
        if (box.width() > kClick && box.height() > kClick)
            zoomIntoBox(box);
        else
            Q_EMIT menuRequested(event.globalPosition().toPoint(), m_plotIndex);
    }
    return true;
}

void ScopeMouse::zoomIntoBox(const QRect &box)
{
    ScopePlot &plot = m_stack.plot(m_plotIndex);
    const QRect area = plot.rect->rect();
    const QRect inside = box.intersected(area);
    if (inside.isEmpty())
        return;
    for (ValueAxis &axis : plot.axes) {
        const QCPRange range = axis.axis->range();
        const double top = fractionIn(inside.top(), area.top(), area.height());
        const double bottom = fractionIn(inside.bottom() + 1, area.top(), area.height());
        axis.automatic = false;
        axis.axis->setRange(range.upper - bottom * range.size(), range.upper - top * range.size());
    }
    const ScopeView::TimeRange time = m_view.visibleRange();
    const double span = time.to - time.from;
    const double left = fractionIn(inside.left(), area.left(), area.width());
    const double right = fractionIn(inside.right() + 1, area.left(), area.width());
    m_view.setVisibleRange(time.from + left * span, time.from + right * span);
}

/// A notch is a step of the gain, as on a bench scope: 1, 2 or 5 of the unit for a division. The value under the mouse
/// stays there.
void ScopeMouse::turnAxis(QCPAxis &axis, double y, double notches)
{
    m_turned = notches * m_turned < 0 ? notches : m_turned + notches; // a turn back counts at once
    const int steps = static_cast<int>(m_turned);
    m_turned -= steps;
    if (steps == 0)
        return;
    const double wanted = steppedScale(axis.range().size() / kDivisions, -steps) * kDivisions;
    axis.scaleRange(wanted / axis.range().size(), axis.pixelToCoord(y));
    m_view.redraw();
}

bool ScopeMouse::wheel(const QWheelEvent &event)
{
    const QPoint angle = event.angleDelta();
    const double notches = (angle.y() != 0 ? angle.y() : angle.x()) / kWheelNotch;
    const int index = m_stack.plotAt(event.position());
    if (notches == 0.0 || index < 0)
        return true;
    const double factor = std::pow(kZoomPerNotch, notches);
    if (ValueAxis *axis = m_stack.valueAxisAt(event.position())) {
        axis->automatic = false;
        turnAxis(*axis->axis, event.position().y(), notches);
        return true;
    }
    if (event.modifiers().testFlag(Qt::ShiftModifier) || angle.y() == 0) {
        m_view.time().pan(-0.1 * notches);
        return true;
    }
    if (m_view.time().following()) {
        m_view.time().zoom(factor); // the newest sample stays at the right edge
        return true;
    }
    const QRect area = m_stack.plot(index).rect->rect();
    const ScopeView::TimeRange time = m_view.visibleRange();
    const double at = fractionIn(event.position().x(), area.left(), area.width());
    const double center = time.from + at * (time.to - time.from);
    m_view.setVisibleRange(
        center - (center - time.from) / factor, center + (time.to - center) / factor);
    return true;
}

} // namespace widgets
