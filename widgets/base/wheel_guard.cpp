#include "widgets/base/wheel_guard.h"

#include <QEvent>
#include <QWidget>

namespace widgets {

WheelGuard::WheelGuard(QWidget *control)
    : QObject(control)
{
    control->setFocusPolicy(Qt::StrongFocus);
    control->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject *watched, QEvent *event)
{
    const auto *control = qobject_cast<QWidget *>(watched);
    if (event->type() != QEvent::Wheel || (control && control->hasFocus()))
        return QObject::eventFilter(watched, event);
    event->ignore();
    return true;
}

} // namespace widgets
