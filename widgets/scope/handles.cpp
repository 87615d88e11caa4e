#include "widgets/scope/handles.h"

#include "widgets/scope/cursors.h"
#include "widgets/scope/plot_stack.h"
#include "widgets/scope/view.h"

#include <algorithm>
#include <cmath>

namespace widgets {

namespace {
constexpr double kReach = 4.0; ///< pixels beside a line that still take it
constexpr double kMark = 9.0; ///< the same around a mark's middle

CursorEnd endOf(Handle handle) { return handle == Handle::CursorA ? CursorEnd::A : CursorEnd::B; }
} // namespace

std::optional<Handle> ScopeHandles::at(const QPointF &position) const
{
    const auto trigger = triggerAt(position);
    return trigger ? trigger : cursorAt(position);
}

std::optional<Handle> ScopeHandles::cursorAt(const QPointF &position) const
{
    const int index = m_stack.plotAt(position);
    if (index < 0 || !m_view.cursors().visible())
        return std::nullopt;
    const QRect area = m_stack.plot(index).rect->rect();
    const bool inside = position.x() >= area.left() - kReach
        && position.x() <= area.right() + kReach && position.y() >= area.top()
        && position.y() <= area.bottom();
    if (!inside)
        return std::nullopt;
    const QCPAxis *axis = m_stack.plot(index).timeAxis();
    const auto distance = [&](CursorEnd end) {
        return std::abs(axis->coordToPixel(m_view.cursors().pair().at(end)) - position.x());
    };
    const double toA = distance(CursorEnd::A);
    const double toB = distance(CursorEnd::B);
    if (std::min(toA, toB) > kReach)
        return std::nullopt;
    return toA < toB ? Handle::CursorA : Handle::CursorB;
}

/// The flag at the top edge and the arrows beside the right one.
std::optional<Handle> ScopeHandles::triggerAt(const QPointF &position) const
{
    const TriggerMarks &marks = m_view.triggerMarks();
    if (!marks.position)
        return std::nullopt;
    const QRect first = m_stack.plot(0).rect->rect();
    const double x = m_stack.plot(0).timeAxis()->coordToPixel(*marks.position);
    if (std::abs(position.x() - x) <= kMark && position.y() >= first.top() - kMark
        && position.y() <= first.top() + kMark)
        return Handle::TriggerPosition;
    const Trace *trace = m_stack.trace(marks.source);
    if (!trace)
        return std::nullopt;
    const QRect plot = m_stack.plot(m_stack.plotOf(marks.source)).rect->rect();
    if (position.x() < plot.right() - 1 || position.x() > plot.right() + 1.5 * kMark)
        return std::nullopt;
    std::optional<Handle> found;
    double nearest = kMark;
    for (std::size_t i = 0; i < marks.levels.size(); ++i) {
        const double y = std::clamp(trace->valueAxis->coordToPixel(marks.levels[i]),
            double(plot.top()), double(plot.bottom()));
        if (std::abs(position.y() - y) <= nearest) {
            nearest = std::abs(position.y() - y);
            found = i == 0 ? Handle::LowerLevel : Handle::UpperLevel;
        }
    }
    return found;
}

void ScopeHandles::accept(Handle handle)
{
    if (handle == Handle::CursorA || handle == Handle::CursorB)
        m_view.cursors().setActive(endOf(handle));
}

void ScopeHandles::move(Handle handle, const QPointF &position)
{
    switch (handle) {
    case Handle::CursorA:
    case Handle::CursorB:
        m_view.cursors().move(endOf(handle), m_view.time().timeAt(position.x()));
        return;
    case Handle::TriggerPosition:
        Q_EMIT m_view.triggerPositionMoved(m_view.time().timeAt(position.x()));
        return;
    case Handle::LowerLevel:
    case Handle::UpperLevel:
        break;
    }
    if (const Trace *trace = m_stack.trace(m_view.triggerMarks().source)) {
        const double value = trace->valueAxis->pixelToCoord(position.y());
        Q_EMIT m_view.triggerLevelMoved(handle == Handle::LowerLevel ? 0 : 1, value);
    }
}

Qt::CursorShape ScopeHandles::shape(Handle handle) const
{
    const bool level = handle == Handle::LowerLevel || handle == Handle::UpperLevel;
    return level ? Qt::SizeVerCursor : Qt::SizeHorCursor;
}

} // namespace widgets
