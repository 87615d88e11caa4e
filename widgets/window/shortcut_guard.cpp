#include "widgets/window/shortcut_guard.h"

#include "widgets/control/motor_button.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>

namespace widgets {
namespace {

/// Whether the Space bar does something in this control that no other key does.
bool needsSpace(QObject *focused)
{
    if (qobject_cast<QAbstractButton *>(focused) != nullptr)
        return qobject_cast<MotorButton *>(focused) == nullptr;
    if (const auto *view = qobject_cast<QAbstractItemView *>(focused))
        return view->currentIndex().siblingAtColumn(0).flags().testFlag(Qt::ItemIsUserCheckable);
    return qobject_cast<QComboBox *>(focused) != nullptr;
}

} // namespace

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
    if (plain && key->key() == Qt::Key_Space && needsSpace(watched)) {
        event->accept();
        return true;
    }
    // A field without a change of its own leaves undo and redo to what was written.
    if (const auto *field = qobject_cast<QLineEdit *>(watched))
        if ((key->matches(QKeySequence::Undo) && !field->isUndoAvailable())
            || (key->matches(QKeySequence::Redo) && !field->isRedoAvailable())) {
            event->ignore();
            return true;
        }
    return false;
}

} // namespace widgets
