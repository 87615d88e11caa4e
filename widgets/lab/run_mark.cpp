#include "widgets/lab/run_mark.h"

#include "widgets/base/trace_colors.h"

#include <QCoreApplication>
#include <qcustomplot.h>

#include <array>

namespace widgets {
namespace {

struct RunMark {
    Q_DECLARE_TR_FUNCTIONS(RunMark)
};

struct Shape {
    QCPScatterStyle::ScatterShape shape;
    const char *name;
};
constexpr std::array<Shape, kTraceColors> kShapes{{
    {QCPScatterStyle::ssCircle, QT_TRANSLATE_NOOP("RunMark", "circle")},
    {QCPScatterStyle::ssSquare, QT_TRANSLATE_NOOP("RunMark", "square")},
    {QCPScatterStyle::ssTriangle, QT_TRANSLATE_NOOP("RunMark", "triangle")},
    {QCPScatterStyle::ssDiamond, QT_TRANSLATE_NOOP("RunMark", "diamond")},
    {QCPScatterStyle::ssCross, QT_TRANSLATE_NOOP("RunMark", "cross")},
    {QCPScatterStyle::ssTriangleInverted, QT_TRANSLATE_NOOP("RunMark", "triangle upside down")},
    {QCPScatterStyle::ssPlus, QT_TRANSLATE_NOOP("RunMark", "plus")},
    {QCPScatterStyle::ssStar, QT_TRANSLATE_NOOP("RunMark", "star")},
}};
constexpr double kTick = 7.0; ///< pixels

/// Beyond the first eight the same colours come with other shapes.
const Shape &shapeOf(int number)
{
    const int at = number - 1;
    return kShapes[std::size_t((at + at / kTraceColors) % kTraceColors)];
}

} // namespace

QColor runColor(int number, bool dark) { return traceColor((number - 1) % kTraceColors, dark); }

QCPScatterStyle runTick(int number, const QColor &color)
{
    return {shapeOf(number).shape, QPen(color, 1.0), Qt::NoBrush, kTick};
}

QString runTickName(int number) { return RunMark::tr(shapeOf(number).name); }

QPixmap runMark(int number, bool dark, int height, double pixelRatio)
{
    QPixmap mark((QSizeF(2.0 * height, height) * pixelRatio).toSize());
    mark.setDevicePixelRatio(pixelRatio);
    mark.fill(Qt::transparent);
    const QColor color = runColor(number, dark);
    QCPPainter painter(&mark);
    painter.setPen(QPen(color, 0));
    painter.drawLine(QPointF(0.0, height / 2.0), QPointF(2.0 * height, height / 2.0));
    painter.setRenderHint(QPainter::Antialiasing);
    const QCPScatterStyle tick = runTick(number, color);
    tick.applyTo(&painter, painter.pen());
    tick.drawShape(&painter, QPointF(height, height / 2.0));
    return mark;
}

} // namespace widgets
