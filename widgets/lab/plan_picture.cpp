#include "widgets/lab/plan_picture.h"

#include "widgets/base/plot_look.h"
#include "widgets/base/trace_colors.h"
#include "widgets/base/value_text.h"

#include <QEvent>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <algorithm>

namespace widgets {
namespace {

constexpr int kSpeedSlot = 0, kCapSlot = 1, kCurrentSlot = 2;
constexpr double kMargin = 0.12; ///< of the range, on either side

} // namespace

PlanPicture::PlanPicture(const SpeedPlan &plan, QWidget *parent)
    : QWidget(parent)
    , m_speeds(plan)
    , m_plot(new QCustomPlot(this))
{
    setUpPlot(*m_plot);
    setObjectName(QStringLiteral("planPicture"));
    setAccessibleName(tr("Picture of the plan"));
    m_plot->setFocusPolicy(Qt::NoFocus);
    m_plot->setAttribute(Qt::WA_TransparentForMouseEvents);
    QLocale plain = locale();
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    m_plot->setLocale(plain);
    for (QCPAxis *axis : {m_plot->xAxis, m_plot->yAxis, m_plot->yAxis2}) {
        axis->setNumberFormat(QStringLiteral("g"));
        axis->ticker()->setTickCount(4);
    }
    m_plot->xAxis->setLabel(tr("Time without the start [s]"));
    m_plot->yAxis->setLabel(tr("Speed [rpm]"));
    m_plot->yAxis2->setLabel(tr("Current at rest [A]"));
    m_plot->yAxis2->setVisible(!plan.amps.isEmpty());
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    applyPalette();
}

void PlanPicture::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        applyPalette();
}

void PlanPicture::applyPalette()
{
    dressPlot(*m_plot, *this);
    draw();
}

/// Against an axis of their own, on the right, in the colour of their line.
void PlanPicture::drawCurrents()
{
    if (m_speeds.amps.isEmpty())
        return;
    const QColor color = traceColor(kCurrentSlot, isDark(palette()));
    dressAxis(*m_plot->yAxis2, color, font());
    auto *current = m_plot->addGraph(m_plot->xAxis, m_plot->yAxis2);
    current->setPen(QPen(color, 0));
    current->setData(m_speeds.ampSeconds, m_speeds.amps, true);
    const double most = *std::max_element(m_speeds.amps.begin(), m_speeds.amps.end());
    m_plot->yAxis2->setRange(0.0, (1.0 + kMargin) * most);
}

void PlanPicture::draw()
{
    const bool dark = isDark(palette());
    m_plot->clearPlottables();
    m_plot->clearItems();
    const double end = m_speeds.seconds.isEmpty() ? 1.0 : m_speeds.seconds.last();
    auto *speed = m_plot->addGraph();
    speed->setPen(QPen(traceColor(kSpeedSlot, dark), 0));
    speed->setData(m_speeds.seconds, m_speeds.rpm, true);
    drawCurrents();
    const double room = kMargin * (m_speeds.mostRpm - m_speeds.leastRpm);
    m_plot->xAxis->setRange(0.0, end);
    m_plot->yAxis->setRange(m_speeds.leastRpm - room, m_speeds.mostRpm + room);
    const QColor capColor = traceColor(kCapSlot, dark);
    for (const double cap : {m_speeds.leastRpm, m_speeds.mostRpm}) {
        auto *line = m_plot->addGraph();
        line->setPen(QPen(capColor, 0, Qt::DashLine));
        line->setData({0.0, end}, {cap, cap}, true);
        auto *label = new QCPItemText(m_plot);
        label->setText(tr("cap %1 rpm").arg(numberText(cap, 0)));
        label->setColor(capColor);
        label->setFont(font());
        label->setPositionAlignment(
            Qt::AlignRight | (cap == m_speeds.mostRpm ? Qt::AlignTop : Qt::AlignBottom));
        label->position->setCoords(end, cap);
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

} // namespace widgets
