#include "widgets/forms/gain_plot.h"

#include "widgets/forms/gain_number.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace widgets {
namespace {

constexpr double kLeastTop = 1.15, kMostTop = 2.0; ///< of the axis; the step ends at 1
constexpr int kMargin = 4;

double highest(const motor::StepPrediction &step)
{
    return step.response.empty() ? 0.0
                                 : *std::max_element(step.response.begin(), step.response.end());
}

} // namespace

GainPlot::GainPlot(const QString &title, QWidget *parent)
    : QWidget(parent)
    , m_title(title)
{
    setAccessibleName(title);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void GainPlot::setSteps(
    const motor::StepPrediction &planned, const motor::StepPrediction &present, double duration_s)
{
    m_planned = planned;
    m_present = present;
    m_duration_s = duration_s;
    m_reason.clear();
    update();
}

void GainPlot::setReason(const QString &sentence)
{
    m_reason = sentence;
    m_planned = m_present = {};
    update();
}

QSize GainPlot::sizeHint() const
{
    const QFontMetrics text(font());
    return {text.averageCharWidth() * 36, text.height() * 6};
}

QSize GainPlot::minimumSizeHint() const
{
    const QFontMetrics text(font());
    return {text.averageCharWidth() * 24, text.height() * 3};
}

double GainPlot::top() const
{
    return std::clamp(1.05 * std::max(highest(m_planned), highest(m_present)), kLeastTop, kMostTop);
}

void GainPlot::drawStep(
    QPainter &painter, const QRectF &area, const motor::StepPrediction &step) const
{
    QPainterPath path;
    const double full = top(); // looks through both responses
    for (std::size_t i = 0; i < step.response.size(); ++i) {
        const double time = static_cast<double>(i) * step.period_s;
        const double level = std::clamp(step.response[i] / full, 0.0, 1.0);
        const QPointF at(area.left() + time / m_duration_s * area.width(),
            area.bottom() - level * area.height());
        i == 0 ? path.moveTo(at) : path.lineTo(at);
        if (time > m_duration_s)
            break;
    }
    painter.drawPath(path);
}

void GainPlot::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRect(frame);
    const QColor dimmed = palette().color(QPalette::PlaceholderText);
    const QRectF inside = frame.adjusted(kMargin, kMargin, -kMargin, -kMargin);
    if (!m_reason.isEmpty() || !(m_duration_s > 0.0)) {
        painter.setPen(dimmed);
        painter.drawText(inside, Qt::AlignCenter | Qt::TextWordWrap, m_reason);
        return;
    }
    const QFontMetrics text(font());
    const QString hundred = tr("100 %");
    const int left = text.horizontalAdvance(hundred) + kMargin;
    const QRectF area = inside.adjusted(left, 0, 0, -text.height());
    const double one = area.bottom() - area.height() / top();
    painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    painter.drawLine(area.topLeft(), area.bottomLeft());
    painter.setPen(QPen(palette().color(QPalette::Mid), 1.0, Qt::DotLine));
    painter.drawLine(QPointF(area.left(), one), QPointF(area.right(), one));
    painter.setPen(dimmed);
    painter.drawText(
        QRectF(inside.left(), one - text.height() / 2.0, left - kMargin, text.height()),
        Qt::AlignRight | Qt::AlignVCenter, hundred);
    const QRectF below(area.left(), area.bottom(), area.width(), text.height());
    painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter, QStringLiteral("0"));
    painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter,
        tr("%1 ms").arg(significantText(m_duration_s * 1e3, 3)));
    painter.drawText(below, Qt::AlignHCenter | Qt::AlignVCenter, m_title);
    // What is what, where no curve runs.
    if (!m_present.response.empty())
        painter.drawText(area.adjusted(0, 0, -kMargin, -kMargin), Qt::AlignRight | Qt::AlignBottom,
            tr("\u2014 new   - - board"));

    painter.setClipRect(area.adjusted(0, -1, 1, 1));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(dimmed, 1.4, Qt::DashLine));
    drawStep(painter, area, m_present);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
    drawStep(painter, area, m_planned);
    painter.setClipping(false);
}

} // namespace widgets
