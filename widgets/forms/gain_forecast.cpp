#include "widgets/forms/gain_forecast.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/si_text.h"
#include "widgets/forms/gain_label.h"
#include "widgets/forms/gain_number.h"
#include "widgets/forms/gain_plot.h"

#include <QVBoxLayout>

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

} // namespace

GainForecast::GainForecast(QWidget *parent)
    : QWidget(parent)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kFineGrid);
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
