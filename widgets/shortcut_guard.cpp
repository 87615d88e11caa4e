#include "widgets/shortcut_guard.h"

#include "widgets/motor_button.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QKeyEvent>

namespace widgets {

ShortcutGuard::ShortcutGuard(QObject *parent)
    : QObject(parent)
{
    QCoreApplication::instance()->installEventFilter(this);
}

bool ShortcutGuard::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::ShortcutOverride)
        return QObject::eventFilter(watched, event);
    const auto *key = static_cast<QKeyEvent *>(event);
    const bool plain =
        (key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
    if (plain && key->key() == Qt::Key_Space && qobject_cast<QAbstractButton *>(watched)
        && !qobject_cast<MotorButton *>(watched)) {
        event->accept();
        return true;
    }
    return false;
}

} // namespace widgets
