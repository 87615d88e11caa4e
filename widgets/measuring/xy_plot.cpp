#include "widgets/measuring/xy_plot.h"

#include "widgets/base/axis_ticks.h"
#include "widgets/base/trace_colors.h"
#include "widgets/base/value_text.h"
#include "widgets/scope/drawing/axis_ticker.h"

#include <QMouseEvent>
#include <QPainter>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace widgets {

namespace {
constexpr int kTraceSlot = 0;
constexpr double kRoom = 1.06; ///< around everything
constexpr int kBands = 8; ///< of a fading trail
constexpr int kOldest = 36; ///< alpha of 255
constexpr double kDot = 4.0; ///< radius of the newest point
constexpr double kHead = 9.0; ///< length of an arrow's head

XyPlot::Ranges rangesOf(const QCPRange &x, const QCPRange &y)
{
    return {x.lower, x.upper, y.lower, y.upper};
}

/// In steps, so that it stands still while the values move a little.
QCPRange stepped(double low, double high)
{
    const double middle = low + (high - low) / 2;
    const double half = std::max((high - low) / 2 * kRoom, std::abs(middle) * 1e-6 + 1e-9);
    const double step = tickStep(2.0 * half, 8);
    return {step * std::floor((middle - half) / step), step * std::ceil((middle + half) / step)};
}

} // namespace

XyPlot::XyPlot(QWidget *parent)
    : KeyedPlot(QStringLiteral("xyPlot"), tr("XY picture"), parent)
    , m_glass(new QWidget(&plot()))
{
    for (QCPAxis *axis : {plot().xAxis, plot().yAxis})
        axis->setTicker(QSharedPointer<AxisTicker>::create(AxisTicker::Labels::Values));
    plot().axisRect()->setMinimumMargins(QMargins(8, 8, 14, 4));
    m_glass->setObjectName(QStringLiteral("xyGlass"));
    m_glass->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_glass->installEventFilter(this);
    setMinimumSize(220, 140);
    connect(&plot(), &QCustomPlot::afterReplot, m_glass, qOverload<>(&QWidget::update));
    dress();
}

QRect XyPlot::area() const { return plot().axisRect()->rect(); }

XyPlot::Ranges XyPlot::ranges() const
{
    return rangesOf(plot().xAxis->range(), plot().yAxis->range());
}

QPointF XyPlot::pixel(double x, double y) const
{
    return {plot().xAxis->coordToPixel(x), plot().yAxis->coordToPixel(y)};
}

void XyPlot::showPicture(Picture picture)
{
    const bool other = picture.xLabel != m_picture.xLabel || picture.yLabel != m_picture.yLabel;
    if (other)
        m_moved.reset();
    say({});
    m_picture = std::move(picture);
    plot().xAxis->setLabel(m_picture.xLabel);
    plot().yAxis->setLabel(m_picture.yLabel);
    draw();
}

void XyPlot::showNothing(const QString &why)
{
    m_picture = {};
    m_moved.reset();
    say(why);
    plot().xAxis->setLabel({});
    plot().yAxis->setLabel({});
    draw();
}

void XyPlot::fit()
{
    m_moved.reset();
    draw();
}

/// Everything; zero in the middle of a vector's picture.
XyPlot::Ranges XyPlot::wanted() const
{
    double reach = m_picture.busVolts * (m_picture.hexagon ? 2.0 / 3.0 : 1.0 / std::sqrt(3.0));
    if (m_picture.points.empty() && !(reach > 0.0))
        return {-1.0, 1.0, -1.0, 1.0};
    QCPRange x(0, 0);
    QCPRange y(0, 0);
    if (!m_picture.points.empty() && !m_picture.vector) {
        x = {m_picture.points.front().x, m_picture.points.front().x};
        y = {m_picture.points.front().y, m_picture.points.front().y};
    }
    for (const scope::XyPoint &point : m_picture.points) {
        x.expand(point.x);
        y.expand(point.y);
        reach = std::max({reach, std::abs(point.x), std::abs(point.y)});
    }
    if (m_picture.vector)
        x = y = stepped(-reach, reach);
    else if (m_picture.equal && x.size() > y.size())
        y = {y.center() - x.size() / 2, y.center() + x.size() / 2};
    else if (m_picture.equal)
        x = {x.center() - y.size() / 2, x.center() + y.size() / 2};
    return m_picture.vector ? rangesOf(x, y)
                            : rangesOf(stepped(x.lower, x.upper), stepped(y.lower, y.upper));
}

/// As much more of one axis as it takes for a unit to be as long on both.
XyPlot::Ranges XyPlot::equalised(Ranges r) const
{
    const double width = std::max(1, area().width());
    const double height = std::max(1, area().height());
    const double scale = std::max((r.right - r.left) / width, (r.top - r.bottom) / height);
    const double moreX = (scale * width - (r.right - r.left)) / 2;
    const double moreY = (scale * height - (r.top - r.bottom)) / 2;
    return {r.left - moreX, r.right + moreX, r.bottom - moreY, r.top + moreY};
}

void XyPlot::draw()
{
    // The margins follow the labels, and what is equal follows the margins.
    for (int i = 0; i < 2; ++i) {
        Ranges r = m_moved.value_or(wanted());
        if (m_picture.equal)
            r = equalised(r);
        plot().xAxis->setRange(r.left, r.right);
        plot().yAxis->setRange(r.bottom, r.top);
        const auto ticks = [](QCPAxis *axis, int pixels, int each) {
            axis->ticker().dynamicCast<AxisTicker>()->setMost(
                std::clamp(pixels / each, 2, 10), pixels);
        };
        ticks(plot().xAxis, area().width(), 60);
        ticks(plot().yAxis, area().height(), 30);
        plot().replot(i == 0 ? QCustomPlot::rpImmediateRefresh : QCustomPlot::rpQueuedRefresh);
    }
}

bool XyPlot::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_glass && event->type() == QEvent::Paint) {
        QPainter painter(m_glass);
        paintOn(painter);
        return true;
    }
    if (watched == &plot() && event->type() == QEvent::Resize)
        m_glass->setGeometry(plot().rect());
    if (watched == &plot() && handleMouse(event))
        return true;
    return KeyedPlot::eventFilter(watched, event);
}

bool XyPlot::handleMouse(QEvent *event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        setFocus(Qt::MouseFocusReason);
        m_taken = static_cast<QMouseEvent *>(event)->position();
        return true;
    case QEvent::MouseMove: {
        const auto *mouse = static_cast<QMouseEvent *>(event);
        if (!(mouse->buttons() & Qt::LeftButton))
            return false;
        const QPointF way = mouse->position() - m_taken;
        m_taken = mouse->position();
        shift(-way.x() / std::max(1, area().width()), way.y() / std::max(1, area().height()));
        return true;
    }
    case QEvent::MouseButtonDblClick:
        fit();
        return true;
    case QEvent::Wheel:
        zoom(std::pow(kKeyZoom, static_cast<QWheelEvent *>(event)->angleDelta().y() / 240.0));
        return true;
    default:
        return false;
    }
}

void XyPlot::zoom(double factor)
{
    const Ranges now = ranges();
    const double halfX = (now.right - now.left) / 2 / factor;
    const double halfY = (now.top - now.bottom) / 2 / factor;
    const double x = (now.left + now.right) / 2;
    const double y = (now.bottom + now.top) / 2;
    constexpr double kLeast = 1e-9;
    constexpr double kMost = 1e9;
    if (std::min(halfX, halfY) < kLeast || std::max(halfX, halfY) > kMost)
        return;
    m_moved = Ranges{x - halfX, x + halfX, y - halfY, y + halfY};
    draw();
}

void XyPlot::shift(double shareX, double shareY)
{
    const Ranges now = ranges();
    const double x = shareX * (now.right - now.left);
    const double y = shareY * (now.top - now.bottom);
    m_moved = Ranges{now.left + x, now.right + x, now.bottom + y, now.top + y};
    draw();
}

void XyPlot::paintOn(QPainter &painter)
{
    painter.setClipRect(area());
    if (m_picture.vector) { // the axes through zero, which the grid does not tell from its others
        QColor faint = palette().color(QPalette::Text);
        faint.setAlpha(110);
        painter.setPen(QPen(faint, 0));
        const QPointF zero = pixel(0.0, 0.0);
        painter.drawLine(QPointF(area().left(), zero.y()), QPointF(area().right(), zero.y()));
        painter.drawLine(QPointF(zero.x(), area().top()), QPointF(zero.x(), area().bottom()));
    }
    paintLimits(painter);
    paintTrail(painter);
    paintNewest(painter);
}

/// The hexagon of what six switches reach, and the circle of what they reach without distortion.
void XyPlot::paintLimits(QPainter &painter) const
{
    if (!(m_picture.busVolts > 0.0))
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor ink = palette().color(QPalette::Text);
    ink.setAlpha(150);
    painter.setBrush(Qt::NoBrush);
    const QPointF zero = pixel(0.0, 0.0);
    const double radius = scope::linearVoltage(m_picture.busVolts);
    const QPointF edge = pixel(radius, radius);
    painter.setPen(QPen(ink, 1, Qt::DotLine));
    painter.drawEllipse(zero, edge.x() - zero.x(), zero.y() - edge.y());
    if (m_picture.hexagon) {
        QPolygonF corners;
        for (const scope::XyPoint &corner : scope::voltageHexagon(m_picture.busVolts))
            corners.append(pixel(corner.x, corner.y));
        painter.setPen(QPen(ink, 1, Qt::DashLine));
        painter.drawPolygon(corners);
    }
    painter.setPen(palette().color(QPalette::Text));
    const QString text = tr("bus %1 V").arg(numberText(m_picture.busVolts, 1));
    painter.drawText(QPointF(edge.x() + 4, edge.y() - 2), text);
    painter.restore();
}

void XyPlot::paintTrail(QPainter &painter)
{
    m_strokes = 0;
    const auto &points = m_picture.points;
    if (points.empty() || m_picture.trail == Trail::None)
        return;
    const int bands = m_picture.trail == Trail::Fading ? kBands : 1;
    QColor color = traceColor(kTraceSlot, isDark(palette()));
    QPolygonF line;
    const auto stroke = [&] {
        if (line.size() == 1)
            painter.drawPoint(line.front());
        else if (line.size() > 1)
            painter.drawPolyline(line);
        m_strokes += static_cast<int>(line.size());
        line.clear();
    };
    QPoint last(-100000, -100000);
    for (int band = 0; band < bands; ++band) {
        const std::size_t first = points.size() * std::size_t(band) / std::size_t(bands);
        const std::size_t end = points.size() * std::size_t(band + 1) / std::size_t(bands);
        color.setAlpha(bands == 1 ? 255 : kOldest + (255 - kOldest) * (band + 1) / bands);
        painter.setPen(QPen(color, 0));
        for (std::size_t i = first; i < end; ++i) {
            const QPointF at = pixel(points[i].x, points[i].y);
            const QPoint rounded = at.toPoint();
            if (points[i].first)
                stroke();
            if (rounded == last && !line.isEmpty() && !points[i].first)
                continue;
            line.append(at);
            last = rounded;
        }
        const bool goesOn = !line.isEmpty() && end < points.size() && !points[end].first;
        const QPointF joint = goesOn ? line.back() : QPointF();
        stroke();
        if (goesOn)
            line.append(joint); // on to the next band
    }
}

/// A dot, and an arrow to it where it is the end of a vector: the newest is not told by its colour alone.
void XyPlot::paintNewest(QPainter &painter) const
{
    if (m_picture.points.empty())
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ink = palette().color(QPalette::Text);
    const scope::XyPoint &newest = m_picture.points.back();
    const QPointF tip = pixel(newest.x, newest.y);
    if (m_picture.vector) {
        const QPointF zero = pixel(0.0, 0.0);
        painter.setPen(QPen(ink, 1.5));
        painter.drawLine(zero, tip);
        const double length = std::hypot(tip.x() - zero.x(), tip.y() - zero.y());
        if (length > 2.0 * kHead) {
            const QPointF along = (tip - zero) / length * kHead;
            const QPointF across(-along.y() * 0.4, along.x() * 0.4);
            painter.setBrush(ink);
            painter.drawPolygon(QPolygonF{tip, tip - along + across, tip - along - across});
            return;
        }
    }
    painter.setPen(QPen(ink, 1.5));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawEllipse(tip, kDot, kDot);
}

} // namespace widgets
