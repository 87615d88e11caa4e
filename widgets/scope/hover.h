// ScopeHover: time and values under the mouse, beside it, while it is over a plot and nothing is pressed: of each trace
// of that plot the sample that holds there. Covers the plots and takes no mouse itself.
#pragma once

#include <QPointF>
#include <QWidget>

#include <optional>

namespace capture {
class Capture;
}

namespace widgets {

class PlotStack;
class ScopeView;

class ScopeHover : public QWidget {
    Q_OBJECT
public:
    /// All outlive it; covers `plot`. @param view  whose time and digits it shows
    ScopeHover(const ScopeView &view, const PlotStack &stack, const capture::Capture &capture,
        QWidget &plot);

public Q_SLOTS:
    void showAt(std::optional<QPointF> position); ///< of the mouse; empty: it is elsewhere or busy
    void follow(); ///< the picture moved under the mouse

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    const ScopeView &m_view;
    const PlotStack &m_stack;
    const capture::Capture &m_capture;
    std::optional<QPointF> m_position;
};

} // namespace widgets
