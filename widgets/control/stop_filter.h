// StopFilter: the Esc key stops the motors, wherever the focus is. Installed on the application, because a shortcut
// does not fire under modal dialogs, message boxes, menus and popups. Esc still does there what it always does.
#pragma once

#include <QObject>

#include <optional>

class QKeyEvent;

namespace widgets {

class StopFilter : public QObject {
    Q_OBJECT
public:
    explicit StopFilter(QObject *parent = nullptr);

Q_SIGNALS:
    void stopPressed(); ///< once for each time the key goes down; auto-repeat is not an act

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    // One act is seen many times: as ShortcutOverride, as KeyPress, at every widget it climbs to; all of them carry
    // the time stamp of the one key press.
    std::optional<quint64> m_act;
};

} // namespace widgets
