// The scope: stacked plots with one time axis, several value axes each, drawn from a Capture. It shows and navigates;
// what is recorded is decided elsewhere, through its signals. It holds no samples of its own.
#pragma once

#include "capture/capture.h"
#include "widgets/scope/cursors.h"
#include "widgets/scope/drawing/marks.h"
#include "widgets/scope/events/log.h"
#include "widgets/scope/time_window.h"

#include <QElapsedTimer>
#include <QMap>
#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <memory>

class QLabel;
class QMenu;
class QWindow;

namespace widgets {

class CursorActions;
class EventLane;
class PlotStack;
class ScopeCanvas;
class ScopeColors;
class ScopeDrop;
class ScopeGhosts;
class ScopeMouse;
class ScopeOverview;
class ScopeOverlay;
class StaleMark;

class ScopeView : public QWidget {
    Q_OBJECT
public:
    /// Both outlive the view and are only touched in the GUI thread. @param events  in the lane above the traces
    ScopeView(capture::Capture &capture, EventLog &events, QWidget *parent = nullptr);
    ~ScopeView() override;

    /// Shows a channel of the capture; `plot` is clipped to [0, plotCount()], plotCount() makes a new one.
    /// A channel whose unit an axis of the plot already has shares that axis.
    /// @param alone  in a new plot above that one
    void addChannel(capture::ChannelId channel, int plot = 0, bool alone = false);
    void removeChannel(capture::ChannelId channel);
    /// To another plot, as in addChannel(); its colour and its samples stay.
    void moveChannel(capture::ChannelId channel, int plot);
    QList<capture::ChannelId> channels() const;
    int plotCount() const;
    int plotOf(capture::ChannelId channel) const; ///< -1 if it is not shown
    QColor colorOf(capture::ChannelId channel) const;
    using TimeRange = TimeWindow::Range;
    TimeRange visibleRange() const { return m_time->range(); }
    /// False: the picture stands still, recording goes on.
    bool running() const { return m_running; }
    bool gridVisible() const;
    /// Where its traces are drawn, in this widget's pixels; empty if there is none.
    QRect plotRect(int plot) const;
    ValueRange valueRangeOf(capture::ChannelId channel) const; ///< of the axis it is drawn on
    /// Of the axes that were set by hand, by the name of a signal on each.
    QMap<QString, ValueRange> heldRanges() const;
    void setHeldRanges(const QMap<QString, ValueRange> &ranges); ///< the other axes fit themselves
    std::optional<capture::ChannelId> selectedChannel() const; ///< the trace clicked in the legend
    bool overviewVisible() const;
    /// The step in which a channel's values are written out; 0 if it is not shown.
    double readingStepOf(capture::ChannelId channel) const;
    QString nameOf(capture::ChannelId channel) const; ///< fit to be shown; empty if it is not there
    const TriggerMarks &triggerMarks() const { return m_marks; }
    Cursors &cursors() { return m_cursors; }
    const Cursors &cursors() const { return m_cursors; }
    EventLog &events() { return m_events; }

    // What it is made of, each with its own wishes.
    TimeWindow &time() const { return *m_time; }
    StaleMark &staleMark() const { return *m_stale; }
    CursorActions &cursorActions() { return *m_cursorActions; }
    ScopeColors &colors() { return *m_colors; }
    ScopeGhosts &ghosts() { return *m_ghosts; }

    /// For the status bar and for tests: redraws since the view was made.
    quint64 redraws() const { return m_redraws; }
    /// Draws now what waits for its window to be seen, for a picture that is taken of it.
    void catchUp();
    /// The events and the plots with all that stands over them, as shapes, in pixels.
    void drawShapes(QPaintDevice &device);
    QSize shapesSize() const;

public Q_SLOTS:
    /// New samples: redraws at the next frame (at most 60 Hz, 15 Hz while calm).
    void captureChanged();
    /// Five times a second. @param waits  for samples: a trace without new ones is told as such
    void beat(bool waits);
    /// Nothing is driven: new samples need not be drawn so often.
    void setCalm(bool calm) { m_calm = calm; }
    void setRunning(bool running);
    void fitAll(); ///< F
    void fitValues(); ///< Shift+F
    void setVisibleRange(double from, double to); ///< ends following
    void setGridVisible(bool visible); ///< G
    void setOverviewVisible(bool visible); ///< O: the whole recording below the plots
    /// Something that is drawn changed: redraws at the next frame, or once its window is seen again.
    void redraw();
    void setTriggerMarks(const TriggerMarks &marks);
    void setMeasureMarks(const MeasureMarks &marks); ///< what a measurement measured; empty ends it

Q_SIGNALS:
    /// A register was dropped from the tree: onto a plot (-1: beside all of them).
    void registerDropped(quint32 id, int plot);
    void runningChanged(bool running);
    void drawn(); ///< after each redraw
    void channelMoved(quint32 channel); ///< to another plot
    void channelsChanged(); ///< what is shown, or in which channel a register is
    void triggerLevelMoved(int level, double value); ///< by the user, in the source's unit
    void triggerPositionMoved(double seconds); ///< by the user
    /// What can be done with a trace is about to be shown: others add what they do with it.
    void traceMenuOpening(QMenu &menu, quint32 channel);
    void noteWanted(quint32 marker); ///< the user wants to write a marker's note
    /// The user took a signal off the scope; it is gone already.
    void removeRequested(quint32 channel);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void connectParts();
    void showTime(double seconds); ///< moves the picture just so far; not while it follows
    bool seen() const;
    void drawWithin(int frameMs);
    void drawFrame();
    void showOwed();
    bool scopeKey(int key, bool shift);
    bool cursorKey(int key, bool shift);
    void removeSelected();
    std::optional<capture::TimeSpan> shownSpan() const;
    void showContextMenu(const QPoint &globalPosition, int plot);
    void fillContextMenu(QMenu &menu, int plot); ///< of its traces; -1: of all
    void fillTraceMenu(QMenu &menu, capture::ChannelId channel);
    void updateDescription();
    void placeHint();

    capture::Capture &m_capture;
    ScopeCanvas *m_plot;
    QLabel *m_hint;
    StaleMark *m_stale;
    Cursors m_cursors;
    EventLog &m_events;
    EventLane *m_lane;
    ScopeOverview *m_overview;
    std::unique_ptr<PlotStack> m_stack;
    TimeWindow *m_time;
    ScopeOverlay *m_overlay;
    ScopeDrop *m_drop;
    ScopeMouse *m_mouse;
    CursorActions *m_cursorActions;
    ScopeColors *m_colors;
    ScopeGhosts *m_ghosts;
    QTimer m_frame;
    QElapsedTimer m_lastFrame;
    quint64 m_redraws = 0;
    std::uint64_t m_drawnRevision = 0;
    TriggerMarks m_marks;
    bool m_running = true;
    bool m_calm = false;
    bool m_owed = false; ///< a frame, to a window that is not seen
    /// The window, and what it is on the screen: they tell when they are seen.
    QPointer<QWidget> m_top;
    QPointer<QWindow> m_onScreen;
};

/// Where a trace of a unit belongs: beside those that have it, or in a plot of its own.
/// @return  a plot as ScopeView::addChannel() takes it
int plotForUnit(const ScopeView &scope, const capture::Capture &capture, const QString &unit);

} // namespace widgets
