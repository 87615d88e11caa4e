#include "widgets/scope/scope_handles.h"

#include "widgets/scope/cursors.h"
#include "widgets/scope/plot_stack.h"
#include "widgets/scope/scope_view.h"

#include <cmath>

namespace widgets {

namespace {
constexpr double kReach = 4.0; ///< pixels beside a line that still take it

CursorEnd endOf(Handle handle) { return handle == Handle::CursorA ? CursorEnd::A : CursorEnd::B; }
} // namespace

std::optional<Handle> ScopeHandles::at(const QPointF &position) const
{
    const int index = m_stack.plotAt(position);
    if (index < 0)
        return std::nullopt;
    const QRect area = m_stack.plot(index).rect->rect();
    const bool inside = position.x() >= area.left() - kReach
        && position.x() <= area.right() + kReach && position.y() >= area.top()
        && position.y() <= area.bottom();
    if (!inside || !m_view.cursors().visible())
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

void ScopeHandles::take(Handle handle) { m_view.cursors().setActive(endOf(handle)); }

void ScopeHandles::move(Handle handle, const QPointF &position)
{
    m_view.cursors().move(endOf(handle), m_view.timeAt(position.x()));
}

Qt::CursorShape ScopeHandles::shape(Handle) const { return Qt::SizeHorCursor; }

} // namespace widgets
