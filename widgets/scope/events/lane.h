// The lane above the traces that shows what happened, on their clock: a sign and its words for each event, a count
// where they lie too close. Keys go from event to event. It holds nothing; the event log does.
#pragma once

#include "widgets/scope/events/log.h"

#include <QWidget>

namespace widgets {

class ScopeView;

class EventLane : public QWidget {
    Q_OBJECT
public:
    /// Both outlive it.
    EventLane(ScopeView &scope, EventLog &log, QWidget *parent);

    QSize sizeHint() const override;
    int nameWidth() const; ///< pixels that its name needs left of the plots
    /// Events so close that they are drawn as one, with their place in pixels.
    struct Cluster {
        double x = 0.0;
        EventLog::Range range;
        EventKind worst = EventKind::Command;
        std::size_t count() const { return range.last - range.first; }
    };
    std::vector<Cluster> clusters() const; ///< of what is in view, from left to right
    QString textOf(const Cluster &cluster) const; ///< a line for each of the first events
    void paintOn(QPainter &painter) const; ///< without the mark of the keyboard focus
    quint32 selected() const { return m_selected; } ///< 0: none

Q_SIGNALS:
    void markerWanted(double seconds); ///< double-clicked where nothing is
    void noteWanted(quint32 marker); ///< a marker was double-clicked
    void timeWanted(double seconds); ///< an event was chosen: its time should be in the picture

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    const Cluster *at(const std::vector<Cluster> &all, double x) const;
    void paintCluster(QPainter &painter, const Cluster &cluster, double end) const;
    void step(int direction);
    void select(quint32 id);
    void sayIt();
    QRect lane() const; ///< as wide as the plots

    ScopeView &m_scope;
    EventLog &m_log;
    quint32 m_selected = 0;
};

} // namespace widgets
