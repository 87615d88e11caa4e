// What the user does on the scope besides looking at it: the actions for cursors and markers, with their keys, for menu
// and bar. The window places them; what they do is the scope's own.
#pragma once

#include "widgets/scope/view.h"

#include <QAction>

namespace widgets {

class TriggerControl;

class ScopeTools : public QObject {
    Q_OBJECT
public:
    /// @param window  gets the actions, so that their keys work wherever no text is typed
    ScopeTools(ScopeView &scope, TriggerControl &trigger, QWidget &window);

    QAction *cursors() const { return m_cursors; } ///< for the bar, too
    /// For a menu, in groups.
    QList<QList<QAction *>> groups() const { return m_groups; }

    /// A further one. @param slot  of the scope
    template <class Slot>
    QAction *make(const QString &text, const QKeySequence &keys, const QString &says, Slot slot)
    {
        auto *action = new QAction(text, this);
        action->setShortcut(keys);
        if (!says.isEmpty())
            action->setToolTip(says);
        m_window.addAction(action);
        connect(action, &QAction::triggered, &m_scope, slot);
        return action;
    }

private:
    void makeTrigger(TriggerControl &trigger);

    ScopeView &m_scope;
    QWidget &m_window;
    QAction *m_cursors;
    QList<QList<QAction *>> m_groups;
};

} // namespace widgets
