#include "widgets/forms/gain_forecast.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/si_text.h"
#include "widgets/forms/gain_label.h"

#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>

#include <algorithm>
#include <numbers>

namespace widgets {
namespace {

using motor::GainId;

constexpr double kShownTimeConstants = 7.0;
constexpr double kShownOfSpeed = 0.7; ///< of the predicted step

QString percentText(double share) { return significantText(100.0 * share, 2); }

/// "0", or "0 to 4" where it depends on the board's timer.
QString overshootText(const motor::CurrentForecast &forecast)
{
    constexpr double kWorthSaying = 0.005;
    const QString prompt = percentText(forecast.step.overshoot);
    return forecast.lateOvershoot - forecast.step.overshoot < kWorthSaying
        ? prompt
        : GainForecast::tr("%1 to %2", "percent").arg(prompt, percentText(forecast.lateOvershoot));
}

motor::PiGains digitsOf(const motor::PerGain<HeldGain> &board, GainId kp, GainId ki)
{
    return {board[motor::indexOf(kp)].value(), board[motor::indexOf(ki)].value()};
}

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

GainForecast::GainForecast(QWidget *parent)
    : QWidget(parent)
{
    auto *column = bare(new QVBoxLayout(this), kFineGrid);
    m_currentText = new GainLabel("labCurrentText", this);
    m_currentPlot = new GainPlot(tr("Current"), this);
    m_speedText = new GainLabel("labSpeedText", this);
    m_speedPlot = new GainPlot(tr("Speed"), this);
    column->addWidget(m_currentText);
    column->addWidget(m_currentPlot, 1);
    column->addWidget(m_speedText);
    column->addWidget(m_speedPlot, 1);
}

void GainForecast::showPlan(const motor::GainPlan &plan, double asked_radps,
    const motor::GainPlant &plant, const motor::PerGain<HeldGain> &board)
{
    showCurrent(plan, asked_radps, plant, board);
    showSpeed(plan, plant, board);
}

void GainForecast::showCurrent(const motor::GainPlan &plan, double asked_radps,
    const motor::GainPlant &plant, const motor::PerGain<HeldGain> &board)
{
    if (!plan.current) {
        m_currentText->say({});
        m_currentPlot->setReason(tr("No prediction yet."));
        return;
    }
    const motor::CurrentForecast &now = *plan.current;
    const auto hertz = [](double radps) {
        return significantText(radps / (2.0 * std::numbers::pi), 3);
    };
    m_currentText->say(
        tr("Asked %1, at the motor %2 rad/s (%3 Hz). Rise %4 ms, overshoot %5 %, margin "
           "%6\u00b0.")
            .arg(significantText(asked_radps), significantText(now.realBandwidth_radps),
                hertz(now.realBandwidth_radps), significantText(now.step.rise_s * kMilli, 3),
                overshootText(now), significantText(now.phaseMargin_deg, 3)));
    m_currentText->setToolTip(plainToolTip(tr(
        "Rise with a timer that takes the new voltage at once, as on the simulated board. One that "
        "takes it a period later rises quicker and overshoots more.")));
    const double duration = kShownTimeConstants / now.realBandwidth_radps;
    const motor::PiGains present = digitsOf(board, GainId::TorqueKp, GainId::TorqueKi);
    motor::StepPrediction before;
    if (present.kp > 0.0 && present.ki >= 0.0)
        before = motor::forecastCurrent(present, plant.torque(), plant.stage, duration).step;
    m_currentPlot->setSteps(now.step, before, duration);
    m_currentPlot->setAccessibleDescription(m_currentText->text());
}

void GainForecast::showSpeed(const motor::GainPlan &plan, const motor::GainPlant &plant,
    const motor::PerGain<HeldGain> &board)
{
    if (!plan.speed) {
        m_speedText->say({});
        m_speedPlot->setReason(
            plan.current ? tr("The speed loop stays as it is.") : tr("No prediction yet."));
        return;
    }
    const motor::SpeedForecast &now = *plan.speed;
    QString text = tr("Rise %1 ms, margin %2\u00b0. Overshoot %3 %, behind a ramp %4 %.")
                       .arg(significantText(now.step.rise_s * kMilli, 3),
                           significantText(now.margin.phase_deg, 3),
                           percentText(now.step.overshoot), percentText(plan.rampedOvershoot));
    if (now.largestStep_rpm > 0.0)
        text += QLatin1Char(' ')
            + tr("For steps up to %1 rpm.").arg(significantText(now.largestStep_rpm, 2));
    m_speedText->setToolTip(plainToolTip(
        tr("Everything between the wish and the measured speed is %1 ms late. A larger step needs "
           "more than the nominal current, and rises more slowly.")
            .arg(significantText(now.lag_s * kMilli, 3))));
    m_speedText->say(text);
    const double duration =
        kShownOfSpeed * now.step.period_s * static_cast<double>(now.step.response.size());
    const motor::PiGains present = digitsOf(board, GainId::SpeedKp, GainId::SpeedKi);
    const motor::PiGains torque = digitsOf(board, GainId::TorqueKp, GainId::TorqueKi);
    motor::StepPrediction before;
    if (present.kp > 0.0 && present.ki >= 0.0 && torque.kp > 0.0)
        before = motor::forecastSpeed(present, plant,
            motor::realBandwidth_radps(torque.kp, plant.torque(), plant.stage), duration)
                     .step;
    m_speedPlot->setSteps(now.step, before, duration);
    m_speedPlot->setAccessibleDescription(text);
}

} // namespace widgets
