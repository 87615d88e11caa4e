// What the mouse does on the scope: drag pans, the wheel zooms at the mouse, the right button draws a box or opens
// the menu, and on a value axis the same gestures move, stretch and fit that axis.
#pragma once

#include "widgets/scope/cursors.h"
#include "widgets/scope/handles.h"

#include <QObject>
#include <QPoint>
#include <QPointF>
#include <QPointer>
#include <QRect>

class QCPAxis;
class QCustomPlot;
class QMouseEvent;
class QRubberBand;
class QWheelEvent;

namespace widgets {

class PlotStack;
class ScopeDrop;
class ScopeView;

class ScopeMouse : public QObject {
    Q_OBJECT
public:
    ScopeMouse(ScopeView &view, QCustomPlot &plot, PlotStack &stack, ScopeDrop &drop);

    bool eventFilter(QObject *watched, QEvent *event) override;

    /// Of the mouse on the plots, in pixels of the plot widget; empty while it is elsewhere.
    std::optional<QPointF> position() const { return m_position; }
    /// The mouse takes a cursor along until the next click; empty: it lets go.
    void attach(std::optional<CursorEnd> end) { m_attached = end; }
    std::optional<CursorEnd> attached() const { return m_attached; }

Q_SIGNALS:
    void menuRequested(const QPoint &globalPosition, int plot);
    /// Over the plots with nothing pressed or taken along; empty: not so any more.
    void hovered(std::optional<QPointF> position);

private:
    enum class Gesture { None, Pan, MoveAxis, Box, MoveHandle, MoveTrace };

    bool press(const QMouseEvent &event);
    bool move(const QMouseEvent &event);
    bool release(const QMouseEvent &event);
    bool wheel(const QWheelEvent &event);
    bool markTime(const QMouseEvent &event);
    bool takeHandle();
    void pressLeft();
    void hover(const QPointF &position);
    void turnAxis(QCPAxis &axis, double y, double notches);
    void zoomIntoBox(const QRect &box);

    ScopeView &m_view;
    QCustomPlot &m_plot;
    PlotStack &m_stack;
    ScopeDrop &m_drop;
    ScopeHandles m_handles;
    QRubberBand *m_box;
    std::optional<QPointF> m_position;
    std::optional<CursorEnd> m_attached;
    std::optional<Handle> m_handle; ///< being moved
    std::optional<quint32> m_trace; ///< whose legend entry is being dragged
    double m_turned = 0.0; ///< of the wheel over an axis, notches not yet acted upon
    Gesture m_gesture = Gesture::None;
    QPointF m_start;
    int m_plotIndex = -1;
    double m_from = 0.0; ///< the range at the start of the gesture
    double m_to = 1.0;
    QPointer<QObject> m_axis; ///< QCPAxis being moved; kept opaque so that this header stays light
};

} // namespace widgets
