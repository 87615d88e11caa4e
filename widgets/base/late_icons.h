// LateIcons: the Fusion style, whose icons are looked for when they are first painted. Qt asks its style for icons when a
// widget is made, also for those that are seldom seen (the arrow of a menu bar that is too narrow, the cross that clears a
// field), and an icon is searched for in all icon themes of the desktop, and read by the plugins for every kind of picture.
#pragma once

#include <QProxyStyle>

namespace widgets {

class LateIcons : public QProxyStyle {
    Q_OBJECT
public:
    LateIcons();

    /// While this style lasts, as Fusion's without an option and a widget, which may be gone when the icon is painted.
    QIcon standardIcon(StandardPixmap which, const QStyleOption *option = nullptr,
        const QWidget *widget = nullptr) const override;
};

} // namespace widgets
