#include "widgets/base/fields/stepped_edit.h"

#include <QKeyEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <utility>

namespace widgets {

SteppedEdit::SteppedEdit(QWidget *parent)
    : QLineEdit(parent)
{
    setAlignment(Qt::AlignRight);
    setFocusPolicy(Qt::StrongFocus); // not by the wheel
}

/// The keys that step are the scope's, too, which has them in the whole window: here they are the field's.
bool SteppedEdit::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool plain = (key->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
        for (const int own : {Qt::Key_Up, Qt::Key_Down, Qt::Key_PageUp, Qt::Key_PageDown})
            if (plain && key->key() == own) {
                event->accept();
                return true;
            }
    }
    return QLineEdit::event(event);
}

void SteppedEdit::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Up:
        return stepBy(1);
    case Qt::Key_Down:
        return stepBy(-1);
    case Qt::Key_PageUp:
        return stepBy(10);
    case Qt::Key_PageDown:
        return stepBy(-10);
    default:
        QLineEdit::keyPressEvent(event);
    }
}

void SteppedEdit::wheelEvent(QWheelEvent *event)
{
    if (!wheelWanted() || event->angleDelta().y() == 0)
        return event->ignore();
    stepBy(event->angleDelta().y() > 0 ? 1 : -1);
    event->accept();
}

void SteppedEdit::focusInEvent(QFocusEvent *event)
{
    m_clickedInto = event->reason() == Qt::MouseFocusReason;
    QLineEdit::focusInEvent(event);
}

void SteppedEdit::mouseReleaseEvent(QMouseEvent *event)
{
    QLineEdit::mouseReleaseEvent(event);
    if (std::exchange(m_clickedInto, false) && !hasSelectedText())
        selectAll();
}

void followText(QLineEdit &edit, const QString &now)
{
    if (now == edit.text())
        return;
    // A field that is not being edited has no selection. In a window that is not active it is as in one that is.
    const bool all = edit.hasSelectedText() && edit.selectedText() == edit.text();
    const int from = edit.selectionStart(), length = edit.selectionLength();
    const int cursor = edit.cursorPosition();
    edit.setText(now);
    if (all)
        edit.selectAll();
    else if (from >= 0 && from < edit.text().size())
        edit.setSelection(from, length);
    else if (focusIsIn(edit))
        edit.setCursorPosition(cursor);
}

bool focusIsIn(const QWidget &widget) { return widget.window()->focusWidget() == &widget; }

QPalette problemPalette(const QString &problem)
{
    QPalette colors;
    if (!problem.isEmpty()) {
        colors.setColor(QPalette::Base, kRefusedColor);
        colors.setColor(QPalette::Text, Qt::black);
    }
    return colors;
}

void SteppedEdit::showProblem()
{
    const QString sentence = problem();
    setPalette(problemPalette(sentence));
    setAccessibleDescription(sentence);
    if (sentence.isEmpty()) {
        if (const QString told = std::exchange(m_told, {}); !told.isEmpty())
            if (QToolTip::text() == told) // else it is another widget's
                QToolTip::hideText();
    } else if (isVisible() && hasFocus()) {
        m_told = sentence.toHtmlEscaped();
        QToolTip::showText(mapToGlobal(QPoint(0, height())), m_told, this);
    }
}

} // namespace widgets
