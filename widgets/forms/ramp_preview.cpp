#include "widgets/forms/ramp_preview.h"

#include "motor/ramp.h"
#include "widgets/base/plot_look.h"
#include "widgets/base/trace_colors.h"
#include "widgets/base/value_text.h"

#include <QEvent>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <algorithm>

namespace widgets {
namespace {

constexpr int kPlanSlot = 0, kMeasuredSlot = 1;
constexpr double kAround = 0.08; ///< of a range, on either side
constexpr double kShortest_s = 0.1;
constexpr int kPathPoints = 100;

} // namespace

RampPicture plannedRamp(RampKind kind, double from, double to, double seconds, double stair_rpm)
{
    RampPicture picture;
    switch (kind) {
    case RampKind::Speed:
        picture.label = RampPreview::tr("Speed [rpm]");
        picture.stairs = stair_rpm > 0.0;
        if (!picture.stairs) {
            picture.plan = {{0.0, from}, {seconds, to}};
            return picture;
        }
        for (const auto &point : motor::rampPreview(from, to, seconds, stair_rpm))
            picture.plan.push_back({point.time_s, point.speed_rpm});
        return picture;
    case RampKind::Position:
        picture.label = RampPreview::tr("Shaft [\u00b0]");
        for (int i = 0; i <= kPathPoints; ++i) {
            const double share = double(i) / kPathPoints;
            picture.plan.push_back(
                {share * seconds, from + (to - from) * motor::positionShare(share)});
        }
        return picture;
    case RampKind::Torque:
    case RampKind::Current:
        break;
    }
    picture.label = RampPreview::tr("Iq [A]");
    picture.plan = {{0.0, from}, {seconds, to}};
    return picture;
}

RampPreview::RampPreview(QWidget *parent)
    : QWidget(parent)
    , m_plot(new QCustomPlot(this))
    , m_plan(m_plot->addGraph())
    , m_measured(m_plot->addGraph())
    , m_now(new QCPItemStraightLine(m_plot))
{
    setUpPlot(*m_plot);
    setObjectName(QStringLiteral("rampPreview"));
    setAccessibleName(tr("Preview of the ramp"));
    setFocusPolicy(Qt::NoFocus);
    m_plot->setFocusPolicy(Qt::NoFocus);
    m_plot->setLocale(plainLocale(locale()));
    m_plot->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_plot->xAxis->setLabel(tr("Time [s]"));
    m_plot->xAxis->setNumberFormat(QStringLiteral("g"));
    m_plot->yAxis->setNumberFormat(QStringLiteral("g"));
    m_plan->setName(tr("Set-point"));
    m_measured->setName(tr("Measured"));
    m_plot->legend->setVisible(true);
    m_plot->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignRight | Qt::AlignBottom);
    m_now->setVisible(false);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    applyPalette();
}

void RampPreview::applyPalette()
{
    const QPalette colors = palette();
    const bool dark = isDark(colors);
    const QColor text = colors.color(QPalette::Text);
    dressPlot(*m_plot, *this);
    for (QCPAxis *axis : {m_plot->xAxis, m_plot->yAxis})
        axis->ticker()->setTickCount(4);
    m_plan->setPen(QPen(traceColor(kPlanSlot, dark), 2));
    m_measured->setPen(QPen(traceColor(kMeasuredSlot, dark), 1.5, Qt::DashLine));
    m_now->setPen(QPen(text, 0, Qt::DotLine));
    m_plot->legend->setFont(font());
    m_plot->legend->setTextColor(text);
    m_plot->legend->setBrush(Qt::NoBrush);
    m_plot->legend->setBorderPen(Qt::NoPen);
    draw();
}

void RampPreview::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        applyPalette();
}

void RampPreview::showPlan(const RampPicture &picture)
{
    if (picture == m_picture)
        return;
    m_picture = picture;
    draw();
}

void RampPreview::showMeasured(const std::vector<RampPicture::Point> &measured, double now_s)
{
    if (measured == m_points && now_s == m_nowSeconds)
        return;
    m_points = measured;
    m_nowSeconds = now_s;
    draw();
}

void RampPreview::draw()
{
    QVector<double> times, values;
    const auto fill = [&](QCPGraph *graph, const std::vector<RampPicture::Point> &points) {
        times.clear();
        values.clear();
        for (const auto &point : points) {
            times.append(point.seconds);
            values.append(point.value);
        }
        graph->setData(times, values, true);
    };
    double end = kShortest_s, least = 0.0, most = 0.0;
    for (const auto *points : {&m_picture.plan, &m_points})
        for (const auto &point : *points) {
            end = std::max(end, point.seconds);
            least = std::min(least, point.value);
            most = std::max(most, point.value);
        }
    std::vector<RampPicture::Point> plan = m_picture.plan;
    if (!plan.empty()) // and stays there
        plan.push_back({end * (1.0 + kAround), plan.back().value});
    m_plan->setLineStyle(m_picture.stairs ? QCPGraph::lsStepLeft : QCPGraph::lsLine);
    fill(m_plan, plan);
    fill(m_measured, m_points);
    const bool both = !m_points.empty();
    m_plot->legend->setVisible(both);
    m_now->setVisible(m_nowSeconds >= 0.0);
    m_now->point1->setCoords(m_nowSeconds, 0.0);
    m_now->point2->setCoords(m_nowSeconds, 1.0);
    const double room = most > least ? kAround * (most - least) : 1.0;
    m_plot->xAxis->setRange(0.0, end * (1.0 + kAround));
    m_plot->yAxis->setRange(least - room, most + room);
    m_plot->yAxis->setLabel(m_picture.label);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

} // namespace widgets
