// The scope: stacked plots with one time axis, several value axes each, drawn from a Capture. It shows and navigates;
// what is recorded is decided elsewhere, through its signals. It holds no samples of its own.
#pragma once

#include "capture/capture.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <memory>

class QCustomPlot;
class QLabel;
class QMenu;
class QRubberBand;

namespace widgets {

class PlotStack;
class ScopeMouse;
class StaleMark;

class ScopeView : public QWidget {
    Q_OBJECT
public:
    /// @param capture  outlives the view; only touched in the GUI thread
    explicit ScopeView(capture::Capture &capture, QWidget *parent = nullptr);
    ~ScopeView() override;

    /// Shows a channel of the capture; `plot` is clipped to [0, plotCount()], plotCount() makes a new one.
    /// A channel whose unit an axis of the plot already has shares that axis.
    void addChannel(capture::ChannelId channel, int plot = 0);
    void removeChannel(capture::ChannelId channel);
    QList<capture::ChannelId> channels() const;
    int plotCount() const;
    int plotOf(capture::ChannelId channel) const; ///< -1 if it is not shown
    QColor colorOf(capture::ChannelId channel) const;

    struct TimeRange {
        double from = 0.0, to = 1.0; ///< seconds on the session's axis
    };
    TimeRange visibleRange() const;
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

    /// For the status bar and for tests: redraws since the view was made.
    quint64 redraws() const { return m_redraws; }
    QCustomPlot &plotWidget() { return *m_plot; } ///< for the scope's own parts

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
    void removeSelected(); ///< Delete: takes the trace that was clicked in the legend off the scope
    void redraw(); ///< something that is drawn changed: redraws at the next frame

Q_SIGNALS:
    /// A register was dropped from the tree: onto a plot (-1: beside all of them).
    void registerDropped(quint32 id, int plot);
    void runningChanged(bool running);
    void followingChanged(bool following);
    void visibleRangeChanged(double from, double to);
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
    void jumpToNewest();
    std::optional<capture::TimeSpan> shownSpan() const;
    void showContextMenu(const QPoint &globalPosition, int plot);
    void fillContextMenu(QMenu &menu, int plot);
    void updateDescription();
    int dropPlotAt(const QPoint &position) const;
    void highlightDrop(int plot);

    capture::Capture &m_capture;
    QCustomPlot *m_plot;
    QLabel *m_hint;
    QRubberBand *m_dropMark;
    StaleMark *m_stale;
    std::unique_ptr<PlotStack> m_stack;
    ScopeMouse *m_mouse;
    QTimer m_frame;
    QElapsedTimer m_lastFrame;
    quint64 m_redraws = 0;
    std::uint64_t m_drawnRevision = 0;
    TimeRange m_range{0.0, 5.0};
    bool m_running = true;
    bool m_following = true;
};

/// Mime type of registers dragged from the tree: a list of ids as JSON numbers.
inline constexpr char kRegisterMimeType[] = "application/x-rotorscope-registers";

} // namespace widgets
