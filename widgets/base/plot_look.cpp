#include "widgets/base/plot_look.h"

#include <qcustomplot.h>

namespace widgets {

namespace {
constexpr int kFaint = 38; ///< of 255: seen, and never in the way of a trace
constexpr int kQuiet = 150; ///< of 255: a small tick beside one with a number
constexpr int kSmallTick = 3; ///< pixels

class ScreenWatch : public QObject {
public:
    explicit ScreenWatch(QCustomPlot &plot)
        : QObject(&plot)
        , m_plot(plot)
    {
        plot.installEventFilter(this);
    }

private:
    bool eventFilter(QObject *, QEvent *event) override
    {
        const double ratio = m_plot.devicePixelRatioF();
        if (event->type() == QEvent::Paint
            && !qFuzzyCompare(m_plot.bufferDevicePixelRatio(), ratio)) {
            m_plot.setBufferDevicePixelRatio(ratio);
            m_plot.replot(QCustomPlot::rpQueuedRefresh); // drawn now, painted by what goes on here
        }
        return false;
    }
    QCustomPlot &m_plot;
};

} // namespace

void setUpPlot(QCustomPlot &plot)
{
    new ScreenWatch(plot);
    plot.layer(QStringLiteral("overlay"))->setMode(QCPLayer::lmLogical);
}

void colorAxis(QCPAxis &axis, const QColor &color)
{
    QColor quiet = color;
    quiet.setAlpha(kQuiet);
    axis.setBasePen(QPen(color, 0));
    axis.setTickPen(QPen(color, 0));
    axis.setSubTickPen(QPen(quiet, 0));
    axis.setTickLabelColor(color);
    axis.setLabelColor(color);
}

void dressAxis(QCPAxis &axis, const QColor &text, const QFont &font)
{
    QColor faint = text;
    faint.setAlpha(kFaint);
    colorAxis(axis, text);
    axis.setTickLabelFont(font);
    axis.setLabelFont(font);
    axis.setSubTickLength(kSmallTick);
    axis.grid()->setPen(QPen(faint, 0));
    axis.grid()->setZeroLinePen(Qt::NoPen);
}

void dressPlot(QCustomPlot &plot, const QWidget &like)
{
    plot.setBackground(like.palette().brush(QPalette::Base));
    for (QCPAxis *axis : {plot.xAxis, plot.yAxis})
        dressAxis(*axis, like.palette().color(QPalette::Text), like.font());
}

} // namespace widgets
