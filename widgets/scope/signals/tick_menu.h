// TickMenu: a menu whose entries that can be ticked leave it open: one looks for several of them. It closes as every menu does,
// by a click elsewhere or the arrow to the left.
#pragma once

#include <QMenu>

namespace widgets {

class TickMenu : public QMenu {
    Q_OBJECT
public:
    using QMenu::QMenu;

protected:
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    static bool tick(QAction *action);
};

} // namespace widgets
