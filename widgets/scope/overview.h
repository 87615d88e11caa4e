// The zoom window: the whole recording of one trace as a strip below the plots, with a box around what they show. Drag
// the box, its edges or beside it; keys do the same. Read anew some times a second at most: it is about minutes.
#pragma once

#include "capture/capture.h"

#include <QElapsedTimer>
#include <QWidget>

#include <optional>

namespace widgets {

class ScopeView;

class ScopeOverview : public QWidget {
    Q_OBJECT
public:
    /// Both outlive it.
    ScopeOverview(ScopeView &scope, const capture::Capture &capture, QWidget *parent);

    QSize sizeHint() const override;
    QRectF box() const; ///< what the plots show, in pixels; at least wide enough to be taken

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *) override { m_held = Part::None; }
    void keyPressEvent(QKeyEvent *event) override;

private:
    enum class Part { None, Left, Box, Right };
    Part partAt(double x) const;
    void readColumns();
    double timeAt(double x) const;
    double xOf(double seconds) const;

    ScopeView &m_scope;
    const capture::Capture &m_capture;
    std::vector<capture::MinMax> m_columns; ///< one a pixel
    std::optional<capture::TimeSpan> m_span;
    capture::ChannelId m_channel = 0;
    QElapsedTimer m_read;
    Part m_held = Part::None;
    double m_grip = 0.0; ///< seconds from the box's start to where it was taken
};

} // namespace widgets
