#include "widgets/scope/drawing/scope_canvas.h"

namespace widgets {

ScopeCanvas::ScopeCanvas(QWidget *parent)
    : QCustomPlot(parent)
{
}

void ScopeCanvas::refresh()
{
    Q_EMIT beforeReplot();
    updateLayout();
    update();
    Q_EMIT afterReplot();
}

void ScopeCanvas::paintEvent(QPaintEvent *)
{
    // Numbers at the axes are kept as pictures, of the screen that they are on.
    if (const double ratio = devicePixelRatioF(); !qFuzzyCompare(bufferDevicePixelRatio(), ratio))
        setBufferDevicePixelRatio(ratio);
    QCPPainter painter(this);
    QRegion ground(rect());
    for (const QCPAxisRect *plot :
        axisRects()) // which paint all of theirs; at their edges roundings may differ
        ground -= plot->rect().adjusted(1, 1, -1, -1);
    for (const QRect &part : ground)
        painter.fillRect(part, mBackgroundBrush);
    m_laidOut = true;
    draw(&painter);
    m_laidOut = false;
}

void ScopeCanvas::resizeEvent(QResizeEvent *)
{
    setViewport(rect());
    refresh();
}

void ScopeCanvas::updateLayout()
{
    if (!m_laidOut)
        QCustomPlot::updateLayout();
}

} // namespace widgets
