// ToolDocks: docks below the scope, as tabs of one another, hidden until they are asked for. They can stand side by
// side, and float: then each has a stop button of its own. What is in one is made when it is first seen, or in turns
// when nothing else is to be done. It knows no tool by name.
#pragma once

#include "widgets/base/form.h"

#include <QAction>
#include <QList>
#include <QRect>
#include <QSize>
#include <QStringList>

#include <deque>
#include <functional>

class QDockWidget;
class QMainWindow;

namespace widgets {

class Workbench;

/// Goes before its window does: an open dock tells that it goes.
class ToolDocks : public QObject {
    Q_OBJECT
public:
    /// Both outlive it.
    ToolDocks(QMainWindow &window, Workbench &workbench);

    /// The action opens it; `makeForm` gives the form no parent, and is called once.
    /// @param icon  as lineIcon() knows it
    QAction *add(const QString &title, const char *name, const char *icon, const QKeySequence &keys,
        std::function<Form *()> makeForm);
    QList<QAction *> actions() const { return m_actions; }
    QAction *closing() const { return m_close; } ///< closes all that are open
    bool anyOpen() const;
    /// What the window has of its screen. A tool that would make the window higher floats.
    void setRoom(const QSize &room) { m_room = room; }
    /// Closes all others. In this order side by side, or as tabs where the window is too narrow for that.
    void showOnly(const QStringList &names);

public Q_SLOTS:
    void makeOpen(); ///< the forms of docks that are not hidden
    void makeAll(); ///< costs nothing a second time
    void makeInTurns(); ///< one each time that the window has nothing to do

Q_SIGNALS:
    void opened(bool any); ///< one was opened or closed
    void failed(const QString &sentence); ///< as Form's

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Tool {
        QDockWidget *dock = nullptr;
        std::function<Form *()> make;
        Form *form = nullptr; ///< until it is made
    };
    Form *formOf(Tool &tool); ///< makes it, the first time
    void open(std::size_t index);
    bool fits(const QDockWidget &dock) const;
    void floatBelow(Tool &tool);
    bool isWhereItWasPut() const;
    void fitBelow();
    static int heightAt(int width, const Tool &tool);
    void closeAll();

    QMainWindow &m_window;
    Workbench &m_workbench;
    std::deque<Tool> m_tools; ///< each keeps its place when another is added
    QList<QAction *> m_actions;
    QAction *m_close;
    Tool *m_below = nullptr; ///< that floats before the window's lower edge
    QRect m_belowAt; ///< where it was put
    QSize m_room{QWIDGETSIZE_MAX, QWIDGETSIZE_MAX};
};

} // namespace widgets
