#include "widgets/window/shortcut_guard.h"

#include "widgets/control/motor_button.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>

#include <algorithm>
#include <array>

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

/// Of a list or a tree, whose rows they go through, of a slider, a number or a list of choices.
bool needsToMove(QObject *focused, int key)
{
    constexpr std::array kMoves{Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Home, Qt::Key_End};
    if (std::find(kMoves.begin(), kMoves.end(), key) == kMoves.end())
        return false;
    const auto moves = [](QObject *control) {
        return qobject_cast<QAbstractItemView *>(control) != nullptr
            || qobject_cast<QAbstractSlider *>(control) != nullptr
            || qobject_cast<QAbstractSpinBox *>(control) != nullptr
            || qobject_cast<QComboBox *>(control) != nullptr;
    };
    const auto *field = qobject_cast<QLineEdit *>(focused); // perhaps that of a number or a list
    return moves(focused) || (field != nullptr && moves(field->parentWidget()));
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
    if (plain
        && ((key->key() == Qt::Key_Space && needsSpace(watched))
            || needsToMove(watched, key->key()))) {
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
