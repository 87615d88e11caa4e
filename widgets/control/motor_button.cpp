#include "widgets/control/motor_button.h"

#include "widgets/base/look/section_head.h"

#include <QKeyEvent>
#include <QPainter>
#include <QStyle>

namespace widgets {
namespace {

constexpr int kStopHeight = 48;
constexpr int kStopPadding = 18;

} // namespace

void MotorButton::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Select) {
        event->ignore();
        return;
    }
    if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        && event->modifiers() == Qt::NoModifier && !event->isAutoRepeat()) {
        click();
        return;
    }
    QPushButton::keyPressEvent(event);
}

void MotorButton::keyReleaseEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Select)
        event->ignore();
    else
        QPushButton::keyReleaseEvent(event);
}

StopButton::StopButton(QWidget *parent)
    : MotorButton(parent)
{
    setText(tr("Stop motors (Esc)"));
    setAccessibleName(tr("Stop motors"));
    setToolTip(tr("Stops every motor at once, from anywhere: press it or the Esc key.\n"
                  "A program on a PC is no replacement for a switch that removes the power."));
    setCursor(Qt::PointingHandCursor);
    setFont(inBold(font(), 1.1));
    // pressed(), not clicked(): a click is lost when the pointer slides off before the button is let go.
    connect(this, &QPushButton::pressed, this, &StopButton::stopPressed);
}

QSize StopButton::sizeHint() const
{
    const int width = fontMetrics().horizontalAdvance(text()) + 2 * kStopPadding;
    return {std::max(width, 130), kStopHeight};
}

void StopButton::keyPressEvent(QKeyEvent *event)
{
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && !event->isAutoRepeat()) {
        Q_EMIT stopPressed();
        return;
    }
    MotorButton::keyPressEvent(event);
}

void StopButton::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor red = isDown() ? QColor(0x8e, 0x10, 0x10)
        : underMouse()          ? QColor(0xd3, 0x2f, 0x2f)
                                : QColor(0xc0, 0x1f, 0x1f);
    painter.setPen(Qt::NoPen);
    painter.setBrush(red);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    if (hasFocus()) {
        painter.setPen(QPen(Qt::white, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(3, 3, -3, -3), 4, 4);
    }
    painter.setPen(Qt::white);
    painter.drawText(rect(), Qt::AlignCenter, text());
}

} // namespace widgets
