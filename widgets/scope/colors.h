// ScopeColors: the colours that the user gives to signals, and the menu to choose them from.
#pragma once

#include "capture/capture.h"

#include <QMap>
#include <QObject>

#include <optional>

class QMenu;
class QWidget;

namespace widgets {

class PlotStack;

class ScopeColors : public QObject {
    Q_OBJECT
public:
    /// Both outlive it. @param view  whose palette says how the colours look
    ScopeColors(PlotStack &stack, const QWidget &view, QObject *parent = nullptr);

    QMap<QString, int> chosen() const; ///< slots of trace_colors.h by the names of signals
    void setChosen(const QMap<QString, int> &slotsByName); ///< before a channel is shown
    /// For every signal of this name; empty: a colour is found for it again.
    void choose(const QString &name, std::optional<int> slot);
    void fill(QMenu &menu, capture::ChannelId channel); ///< that is shown
    void fill(QMenu &menu, const QString &name); ///< of a signal that may not be shown yet

Q_SIGNALS:
    void changed(); ///< by the user

private:
    PlotStack &m_stack;
    const QWidget &m_view;
};

} // namespace widgets
