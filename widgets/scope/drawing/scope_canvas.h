// What the scope draws on. The plot library draws into a picture of its own, which it clears before and lays on the
// window's behind a ground: three passes over every pixel, which take longer than the traces do. This one paints the
// window itself, of which the traces' images cover the plots, grid and ground included. Includes the slow header: only
// for the scope's own files.
#pragma once

#include <qcustomplot.h>

namespace widgets {

class ScopeCanvas : public QCustomPlot {
    Q_OBJECT
public:
    explicit ScopeCanvas(QWidget *parent = nullptr);
    /// Lays out at once and is painted soon; takes the place of replot(), with the same signals.
    void refresh();

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void updateLayout() override;

private:
    bool m_laidOut = false; ///< for what is painted now
};

} // namespace widgets
