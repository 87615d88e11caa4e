// ShortcutGuard: keeps the scope's single keys from taking a key that a focused control needs: the Space bar still
// ticks a box, also one in a list, opens a list of choices or presses an ordinary button. Motor buttons refuse it, so
// there it stays the scope's. Page and end keys move in lists, sliders and numbers. The other way round, a field takes
// undo and redo only if it has something to undo.
#pragma once

#include <QObject>

namespace widgets {

class ShortcutGuard : public QObject {
    Q_OBJECT
public:
    explicit ShortcutGuard(QObject *parent = nullptr);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace widgets
