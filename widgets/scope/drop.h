// ScopeDrop: the scope as a place to drop registers and traces on: reads the drag, marks where it would land, and says
// where it did.
#pragma once

#include "capture/capture.h"

#include <QList>
#include <QObject>

class QCustomPlot;
class QDropEvent;
class QMimeData;
class QRubberBand;
class QWidget;

namespace widgets {

class PlotStack;

class ScopeDrop : public QObject {
    Q_OBJECT
public:
    /// All outlive it. @param view  gets the drags
    ScopeDrop(QWidget &view, QCustomPlot &plot, const PlotStack &stack);

    // A trace that is dragged by its legend entry; places are in pixels of the view.
    void markTrace(const QPoint &position); ///< where it would land
    void dropTrace(capture::ChannelId channel, const QPoint &position);
    void hideMark();

    bool eventFilter(QObject *watched, QEvent *event) override;

Q_SIGNALS:
    /// A register was dropped from the tree: onto a plot (-1: beside all of them).
    void registerDropped(quint32 id, int plot);
    void traceDropped(quint32 channel, int plot); ///< as in ScopeView::moveChannel()

private:
    int plotAt(const QPoint &position) const;
    void mark(int plot);
    void drop(const QDropEvent &event);

    QWidget &m_view;
    QCustomPlot &m_plot;
    const PlotStack &m_stack;
    QRubberBand *m_mark;
};

/// Ids in a drag of kRegisterMimeType; empty if it holds none or is damaged. At most 64.
QList<quint32> registersIn(const QMimeData &data);

} // namespace widgets
