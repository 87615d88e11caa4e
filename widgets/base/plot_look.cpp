#include "widgets/base/plot_look.h"

#include <qcustomplot.h>

namespace widgets {

void dressPlot(QCustomPlot &plot, const QWidget &like)
{
    constexpr int kFaint = 38; // of 255: seen, and never in the way of a trace
    const QColor text = like.palette().color(QPalette::Text);
    QColor faint = text;
    faint.setAlpha(kFaint);
    plot.setBackground(like.palette().brush(QPalette::Base));
    for (QCPAxis *axis : {plot.xAxis, plot.yAxis}) {
        axis->setBasePen(QPen(text, 0));
        axis->setTickPen(QPen(text, 0));
        axis->setTickLabelColor(text);
        axis->setLabelColor(text);
        axis->setTickLabelFont(like.font());
        axis->setLabelFont(like.font());
        axis->setSubTicks(false);
        axis->grid()->setPen(QPen(faint, 0));
        axis->grid()->setZeroLinePen(Qt::NoPen);
    }
}

} // namespace widgets
