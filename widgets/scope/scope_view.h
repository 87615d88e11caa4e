// The scope: stacked plots with one time axis, several value axes each, drawn from a Capture. It shows and navigates;
// what is recorded is decided elsewhere, through its signals. It holds no samples of its own.
#pragma once

#include "capture/capture.h"
#include "widgets/scope/cursors.h"
#include "widgets/scope/drawing/ghost.h"
#include "widgets/scope/drawing/measure_marks.h"
#include "widgets/scope/events/event_log.h"
#include "widgets/scope/trigger/trigger_marks.h"

#include <QElapsedTimer>
#include <QMap>
#include <QTimer>
#include <QWidget>

#include <array>
#include <memory>

class QCustomPlot;
class QLabel;
class QMenu;
class QRubberBand;

namespace widgets {

class EventLane;
class PlotStack;
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
    void addChannel(capture::ChannelId channel, int plot = 0);
    void removeChannel(capture::ChannelId channel);
    /// To another plot, as in addChannel(); its colour and its samples stay.
    void moveChannel(capture::ChannelId channel, int plot);
    QList<capture::ChannelId> channels() const;
    int plotCount() const;
    int plotOf(capture::ChannelId channel) const; ///< -1 if it is not shown
    QColor colorOf(capture::ChannelId channel) const;
    /// A slot of trace_colors.h for every signal of this name; empty: one is found for it again.
    void setColor(const QString &name, std::optional<int> slot);
    std::optional<int> chosenColor(const QString &name) const; ///< by a person
    QMap<QString, int> chosenColors() const; ///< slots by the names of signals
    void setChosenColors(const QMap<QString, int> &slotsByName); ///< before a channel is added
    /// The colours to choose from, for a channel that is shown.
    void fillColors(QMenu &menu, capture::ChannelId channel);
    void fillColors(QMenu &menu, const QString &name); ///< for one that may not be shown yet

    struct TimeRange {
        double from = 0.0, to = 1.0; ///< seconds on the session's axis
    };
    TimeRange visibleRange() const;
    double timeStep() const; ///< seconds between two lines of the grid
    /// What the time axis and the cursors call zero, in seconds on the session's axis.
    double timeOrigin() const { return m_origin; }
    double timeAt(double x) const; ///< seconds; `x` in this widget's pixels
    double xOf(double seconds) const;
    /// Where the mouse is on the plots; empty if it is not.
    std::optional<double> timeUnderMouse() const;
    bool running() const; ///< false: the picture stands still, recording goes on
    bool following() const; ///< the right edge stays at the newest sample
    bool gridVisible() const;
    /// Hatches the plots and says why what they show is not live; empty ends that.
    void setStale(const QString &why);
    QString stale() const;
    QRect plotRect(int plot)
        const; ///< where its traces are drawn, in this widget's pixels; empty if there is none
    struct ValueRange {
        double from = 0.0, to = 1.0; ///< in the channel's unit
    };
    ValueRange valueRangeOf(capture::ChannelId channel) const; ///< of the axis it is drawn on
    int axisCount(int plot) const; ///< value axes of a plot
    std::optional<capture::ChannelId> selectedChannel() const; ///< the trace clicked in the legend
    bool overviewVisible() const;
    /// The step in which a channel's values are written out; 0 if it is not shown.
    double readingStepOf(capture::ChannelId channel) const;
    QString nameOf(capture::ChannelId channel) const; ///< fit to be shown; empty if it is not there
    const TriggerMarks &triggerMarks() const { return m_marks; }
    static constexpr int kMostGhosts = 16;
    int ghostCount() const { return static_cast<int>(m_ghosts.size()); }
    bool hasReference(Reference which) const { return referenceOf(which).kept != nullptr; }
    bool hasReference() const { return hasReference(Reference::A) || hasReference(Reference::B); }
    Cursors &cursors() { return m_cursors; }
    const Cursors &cursors() const { return m_cursors; }
    EventLog &events() { return m_events; }

    /// For the status bar and for tests: redraws since the view was made.
    quint64 redraws() const { return m_redraws; }
    /// The events and the plots with all that stands over them, as shapes, in pixels.
    void drawShapes(QPaintDevice &device);
    QSize shapesSize() const;

public Q_SLOTS:
    void captureChanged(); ///< new samples: redraws at the next frame (at most 60 Hz)
    void setRunning(bool running);
    void setFollowing(bool following);
    void fitAll(); ///< F
    void fitValues(); ///< Shift+F
    void zoom(double
            factor); ///< > 1 shows less time; around the centre, or the right edge while following
    void pan(double fraction); ///< of the visible span, positive to later
    void setVisibleRange(double from, double to); ///< ends following
    void setGridVisible(bool visible); ///< G
    void setOverviewVisible(bool visible); ///< O: the whole recording below the plots
    void removeSelected(); ///< Delete: takes the trace that was clicked in the legend off the scope
    void redraw(); ///< something that is drawn changed: redraws at the next frame
    void setTimeOrigin(double seconds);
    void setTriggerMarks(const TriggerMarks &marks);
    void setMeasureMarks(const MeasureMarks &marks); ///< what a measurement measured; empty ends it
    void setGhosts(
        std::vector<Ghost> ghosts); ///< behind the traces, newest first; at most kMostGhosts
    /// R, B: the traces as they are now stay dashed and paler behind those that come, at the same place from the trigger
    /// or, in a picture that rolls, from the left edge. With Shift they go.
    void keepReference(widgets::Reference which);
    void dropReference(widgets::Reference which);
    void showTime(double seconds); ///< moves the picture just so far; not while it follows
    void centerOn(double seconds); ///< ends following
    /// M: sets a marker at the mouse, else at the active cursor, else at the newest sample or in the middle.
    void setMarker();
    void setMarkerAt(double seconds);
    /// C: shows the cursors, inside the picture, or hides them.
    void toggleCursors();
    /// 1 and 2: the mouse takes this cursor along until the next click or the same key; without a mouse on the
    /// plots it comes into view. Either way arrow keys move it.
    void takeCursor(widgets::CursorEnd end);
    /// Moves the active cursor by so many samples of the selected trace, or of the first one.
    void nudgeCursor(int samples);

Q_SIGNALS:
    /// A register was dropped from the tree: onto a plot (-1: beside all of them).
    void registerDropped(quint32 id, int plot);
    void runningChanged(bool running);
    void followingChanged(bool following);
    void visibleRangeChanged(double from, double to);
    void drawn(); ///< after each redraw
    void channelMoved(quint32 channel); ///< to another plot
    void referencesChanged(); ///< hasReference()
    void colorsChanged(); ///< by a person
    void channelsChanged(); ///< what is shown, or in which channel a register is
    void triggerLevelMoved(int level, double value); ///< by a person, in the source's unit
    void triggerPositionMoved(double seconds); ///< by a person
    void timeOriginChanged(double seconds);
    void noteWanted(quint32 marker); ///< the person wants to write a marker's note
    void removeRequested(
        quint32 channel); ///< the person took a signal off the scope; it is gone already

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dragMoveEvent(QDragMoveEvent *event) override;
    void dragLeaveEvent(QDragLeaveEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void drawFrame();
    void applyRange(TimeRange range);
    void placeInView(CursorEnd end, double share);
    bool inView(double seconds) const;
    const capture::Channel *nudgeChannel() const;
    bool scopeKey(int key, bool shift);
    bool cursorKey(int key, bool shift);
    void jumpToNewest();
    std::optional<capture::TimeSpan> shownSpan() const;
    void showContextMenu(const QPoint &globalPosition, int plot);
    void fillContextMenu(QMenu &menu, int plot);
    void updateDescription();
    void placeGhosts();
    double ghostZero() const;
    const Ghost &referenceOf(Reference which) const
    {
        return m_references[static_cast<std::size_t>(which)];
    }
    friend class ScopeMouse; // drags traces as drags drop registers
    int dropPlotAt(const QPoint &position) const;
    void highlightDrop(int plot);
    void hideDropMark();
    void dropTrace(capture::ChannelId channel, const QPoint &position);

    capture::Capture &m_capture;
    QCustomPlot *m_plot;
    QLabel *m_hint;
    QRubberBand *m_dropMark;
    StaleMark *m_stale;
    Cursors m_cursors;
    EventLog &m_events;
    EventLane *m_lane;
    ScopeOverview *m_overview;
    std::unique_ptr<PlotStack> m_stack;
    ScopeOverlay *m_overlay;
    ScopeMouse *m_mouse;
    QTimer m_frame;
    QElapsedTimer m_lastFrame;
    quint64 m_redraws = 0;
    std::uint64_t m_drawnRevision = 0;
    TimeRange m_range{0.0, 5.0};
    double m_origin = 0.0;
    TriggerMarks m_marks;
    std::vector<Ghost> m_ghosts;
    std::array<Ghost, 2> m_references; ///< their shift is the time that lies at ghostZero()
    bool m_running = true;
    bool m_following = true;
};

} // namespace widgets
