// The parts of the scope's picture that a mouse can take and move: which one is at a point, and what moving it does.
// Knows no gestures; mouse.h has those.
#pragma once

#include <QPointF>

#include <cstdint>
#include <optional>

namespace widgets {

class PlotStack;
class ScopeView;

enum class Handle : std::uint8_t { CursorA, CursorB, LowerLevel, UpperLevel, TriggerPosition };

class ScopeHandles {
public:
    ScopeHandles(ScopeView &view, PlotStack &stack)
        : m_view(view)
        , m_stack(stack)
    {
    }

    /// What can be taken at `position` of the plot widget; of several the one drawn last.
    std::optional<Handle> at(const QPointF &position) const;
    void accept(Handle handle); ///< the mouse went down on it
    void move(Handle handle, const QPointF &position);
    Qt::CursorShape shape(Handle handle) const;

private:
    std::optional<Handle> cursorAt(const QPointF &position) const;
    std::optional<Handle> triggerAt(const QPointF &position) const;

    ScopeView &m_view;
    PlotStack &m_stack;
};

} // namespace widgets
