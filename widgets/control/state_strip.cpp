#include "widgets/control/state_strip.h"

#include "widgets/base/device_text.h"
#include "widgets/base/lamp.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace widgets {
namespace {

constexpr int kMostStates = 3; ///< in a row
constexpr int kRows = 3; ///< that it has room for: no drive has more than eight steps
constexpr int kCellGap = 3;
constexpr int kPadding = 4; // above and below the text, together
constexpr int kBeside = 4; // of the text, on each side
constexpr double kSmaller = 0.86; // than the font around

QFont smallFont(const QFont &font, bool bold)
{
    QFont small = font;
    small.setPointSizeF(font.pointSizeF() * kSmaller);
    small.setBold(bold);
    return small;
}

} // namespace

QColor stateColor(drive::MotorState state, const QPalette &palette)
{
    using drive::MotorState;
    const auto light = state == MotorState::Running ? Lamp::Light::On
        : state == MotorState::FaultNow             ? Lamp::Light::Bad
        : state == MotorState::FaultOver || state == MotorState::Starting
            || state == MotorState::Stopping
        ? Lamp::Light::Waiting
        : Lamp::Light::Off;
    return light == Lamp::Light::Off ? palette.color(QPalette::WindowText)
                                     : Lamp::colorOf(light, palette);
}

StateStrip::StateStrip(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("stateStrip"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    describe();
}

void StateStrip::setSteps(std::vector<drive::StateStep> steps)
{
    m_steps = std::move(steps);
    m_current = -1;
    m_lit.clear();
    describe();
    update();
}

void StateStrip::show(const drive::MotorStatus &status, bool believed)
{
    int current = -1;
    for (std::size_t i = 0; believed && i < m_steps.size(); ++i) {
        const auto &names = m_steps[i].names;
        if (std::find(names.begin(), names.end(), status.stateName) != names.end())
            current = static_cast<int>(i);
    }
    const QString lit = current >= 0 ? deviceText(status.stateName) : QString();
    if (current == m_current && lit == m_lit)
        return;
    m_current = current;
    m_lit = lit;
    describe();
    update();
}

void StateStrip::describe()
{
    setAccessibleName(m_lit.isEmpty() ? tr("State of the motor: not known")
                                      : tr("State of the motor: %1").arg(m_lit));
}

QSize StateStrip::sizeHint() const
{
    const int height = QFontMetrics(smallFont(font(), true)).height() + kPadding;
    return {kMostStates * 76, kRows * (height + kCellGap) - kCellGap};
}

/// As few as there is room for below each other: names are long.
int StateStrip::columns() const
{
    return std::clamp((static_cast<int>(m_steps.size()) + kRows - 1) / kRows, 1, kMostStates);
}

QRect StateStrip::cellRect(std::size_t step) const
{
    const int across = columns();
    const int rows = std::max(kRows, (static_cast<int>(m_steps.size()) + across - 1) / across);
    const int row = static_cast<int>(step) / across, column = static_cast<int>(step) % across;
    const int left = column * (width() + kCellGap) / across;
    const int right = (column + 1) * (width() + kCellGap) / across - kCellGap;
    const int top = row * (height() + kCellGap) / rows;
    const int bottom = (row + 1) * (height() + kCellGap) / rows - kCellGap;
    return {left, top, right - left, bottom - top};
}

QString StateStrip::cellText(std::size_t step) const
{
    if (static_cast<int>(step) == m_current)
        return QStringLiteral("\u25cf ") + m_lit;
    const auto &names = m_steps[step].names;
    if (names.empty())
        return {};
    return deviceText(names.front()) + (names.size() > 2 ? QStringLiteral("\u2026") : QString());
}

/// Cut in its middle: names of states often begin alike.
QString StateStrip::textIn(std::size_t step) const
{
    const bool lit = static_cast<int>(step) == m_current;
    return QFontMetrics(smallFont(font(), lit))
        .elidedText(cellText(step), Qt::ElideMiddle, cellRect(step).width() - 2 * kBeside);
}

void StateStrip::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
        const bool lit = static_cast<int>(i) == m_current;
        const QRectF cell = QRectF(cellRect(i)).adjusted(0.5, 0.5, -0.5, -0.5);
        const QColor light = stateColor(m_steps[i].state, palette());
        painter.setPen(QPen(lit ? light : palette().color(QPalette::Mid), lit ? 2.0 : 1.0));
        painter.setBrush(lit ? QBrush(light) : QBrush(Qt::NoBrush));
        painter.drawRoundedRect(cell, 4, 4);
        painter.setFont(smallFont(font(), lit));
        painter.setPen(lit ? palette().color(QPalette::Base)
                           : palette().color(QPalette::Disabled, QPalette::WindowText));
        painter.drawText(cell, Qt::AlignCenter, textIn(i));
    }
}

bool StateStrip::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
        if (!cellRect(i).contains(help->pos()))
            continue;
        QToolTip::showText(help->globalPos(), plainToolTip(deviceNames(m_steps[i].names)), this);
        return true;
    }
    QToolTip::hideText();
    return true;
}

} // namespace widgets
