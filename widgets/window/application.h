// Application: the QApplication of Rotorscope's windows. The Esc key stops the motors, wherever the focus is and
// whatever loop runs: it is seen in notify(), before any event filter, because the loop of a drag and drop eats the key
// in one. A shortcut would not fire under dialogs, menus and popups either. Esc still does there what it always does.
//
// Dialogs and menu bars of the desktop live outside this process and would keep the key for themselves: they are never
// used.
#pragma once

#include <QApplication>

#include <optional>

namespace widgets {

class Application : public QApplication {
    Q_OBJECT
public:
    /// Both outlive it, as QApplication wants it.
    Application(int &argc, char **argv);

    bool notify(QObject *receiver, QEvent *event) override;

Q_SIGNALS:
    void stopPressed(); ///< once for each time the key goes down; auto-repeat is not an act

private:
    // One act is seen many times: as ShortcutOverride, as KeyPress, at every widget it climbs to; all of them carry
    // the time stamp of the one key press.
    std::optional<quint64> m_act;
};

} // namespace widgets
