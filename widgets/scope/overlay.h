// What stands over the traces and moves without them: the cursors, the markers and the trigger. A transparent child of
// the plot, so that moving a cursor repaints some lines and no trace. Takes no mouse; handles.h says where its
// parts can be taken.
#pragma once

#include "widgets/scope/drawing/marks.h"

#include <QWidget>

class QCustomPlot;

namespace capture {
class Capture;
}

namespace widgets {

class Cursors;
class EventLog;
class PlotStack;
struct CursorPair;

class ScopeOverlay : public QWidget {
    Q_OBJECT
public:
    /// All outlive it; covers `plot`.
    ScopeOverlay(QCustomPlot &plot, const PlotStack &stack, const capture::Capture &capture,
        const Cursors &cursors, const EventLog &events);

    void setMarks(const TriggerMarks &marks);
    void setMeasure(const MeasureMarks &marks);
    const MeasureMarks &measure() const { return m_measure; }

    /// On a printer or in a file: the same over a plot drawn with `painter` in this widget's pixels.
    void paintOn(QPainter &painter) const;

public Q_SLOTS:
    void follow(); ///< shows or hides itself, and repaints

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    void paintMarkers(QPainter &painter) const;
    void paintTrigger(QPainter &painter) const;
    void paintMeasure(QPainter &painter) const;
    void paintPair(QPainter &painter, const CursorPair &pair, bool current) const;
    void paintFlag(
        QPainter &painter, double x, const QString &text, bool strong, bool active) const;
    void paintDots(QPainter &painter, double seconds) const;
    void paintDistance(QPainter &painter, const CursorPair &pair) const;
    QRect area() const; ///< from the top of the first plot to the bottom of the last
    void drawThrough(QPainter &painter, double x) const;
    double xOf(double seconds) const;

    const PlotStack &m_stack;
    const capture::Capture &m_capture;
    const Cursors &m_cursors;
    const EventLog &m_events;
    TriggerMarks m_marks;
    MeasureMarks m_measure;
};

} // namespace widgets
