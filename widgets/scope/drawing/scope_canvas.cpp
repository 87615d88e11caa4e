#include "widgets/scope/drawing/scope_canvas.h"

#include <algorithm>

namespace widgets {

namespace {

/// An axis whose numbers were shown again has none before the next layout, and the library reads them unasked.
bool hasItsNumbers(const QCPAxis *axis)
{
    return !axis->tickLabels() || axis->tickVectorLabels().size() == axis->tickVector().size();
}

} // namespace

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
    m_laidOut = true;
    // They paint all of theirs; at their edges roundings may differ.
    for (const QCPAxisRect *plot : axisRects()) {
        ground -= plot->rect().adjusted(1, 1, -1, -1);
        const QList<QCPAxis *> axes = plot->axes();
        m_laidOut = m_laidOut && std::all_of(axes.begin(), axes.end(), hasItsNumbers);
    }
    for (const QRect &part : ground)
        painter.fillRect(part, mBackgroundBrush);
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
