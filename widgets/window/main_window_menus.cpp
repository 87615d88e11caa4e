// The menus of the main window: only entries that work, each key given once.
#include "widgets/base/device_text.h"
#include "widgets/base/look/line_icon.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/theme.h"
#include "widgets/control/motion_allowed.h"
#include "widgets/control/panel.h"
#include "widgets/files/marker_file.h"
#include "widgets/files/recording_control.h"
#include "widgets/registers/panel.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/tools.h"
#include "widgets/scope/view.h"
#include "widgets/window/about_dialog.h"
#include "widgets/window/connect_bar.h"
#include "widgets/window/first_steps.h"
#include "widgets/window/main_window.h"
#include "widgets/window/replacing.h"
#include "widgets/window/scope_page.h"
#include "widgets/window/searching.h"
#include "widgets/window/tools.h"
#include "widgets/window/workspaces.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMenuBar>
#include <QMouseEvent>
#include <QStackedWidget>

namespace widgets {

namespace {

/// A menu whose entries that can be ticked leave it open: one looks for several of them. It closes as every menu does,
/// by a click elsewhere or the arrow to the left.
class TickMenu : public QMenu {
public:
    using QMenu::QMenu;

protected:
    void mouseReleaseEvent(QMouseEvent *event) override
    {
        if (event->button() != Qt::LeftButton || !tick(actionAt(event->position().toPoint())))
            QMenu::mouseReleaseEvent(event);
    }
    void keyPressEvent(QKeyEvent *event) override
    {
        const int key = event->key();
        const bool chooses = key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space;
        if (!chooses || !tick(activeAction()))
            QMenu::keyPressEvent(event);
    }

private:
    static bool tick(QAction *action)
    {
        if (action == nullptr || !action->isCheckable() || !action->isEnabled())
            return false;
        action->trigger();
        return true;
    }
};

} // namespace

QAction *MainWindow::addAction(
    QMenu *menu, const QString &text, const QKeySequence &keys, const char *icon)
{
    QAction *action = menu->addAction(text);
    if (icon != nullptr)
        setLineIcon(*action, icon);
    action->setShortcut(keys);
    QMainWindow::addAction(action);
    return action;
}

void MainWindow::makeMenus(QMenuBar &bar)
{
    fillFileMenu(bar.addMenu(tr("&File")));
    fillEditMenu(bar.addMenu(tr("&Edit")));
    fillViewMenu(bar.addMenu(tr("&View")));
    fillDeviceMenu(bar.addMenu(tr("&Device")));
    fillMotorMenu(bar.addMenu(tr("&Motor")));
    fillScopeMenu(bar.addMenu(tr("&Scope")));
    QMenu *tools = bar.addMenu(tr("&Tools"));
    tools->addActions(m_tools->docks().actions());
    tools->addSeparator();
    tools->addAction(m_tools->docks().closing());
    QMainWindow::addActions(m_tools->docks().actions());

    QMenu *help = bar.addMenu(tr("&Help"));
    connect(addAction(help, tr("&First steps"), {}, "first-steps"), &QAction::triggered,
        m_firstSteps, &FirstSteps::restart);
    connect(addAction(help, tr("&Keys"), Qt::Key_F1, "keys"), &QAction::triggered, this, [this] {
        finishTools(); // which have keys of their own
        showKeys(*this);
    });
    connect(addAction(help, tr("&About Rotorscope"), {}, "about"), &QAction::triggered, this,
        [this] { showAbout(this); });
}

void MainWindow::fillFileMenu(QMenu *menu)
{
    menu->addActions(m_openActions);
    menu->addMenu(m_recentMenu);
    menu->addSeparator();
    connect(menu->addAction(lineIcon("workspace"), tr("Open a &workspace\u2026")),
        &QAction::triggered, m_workspaces, &Workspaces::askForOpen);
    connect(menu->addAction(lineIcon("save"), tr("Save the wor&kspace\u2026")), &QAction::triggered,
        m_workspaces, &Workspaces::askForSave);
    menu->addSeparator();
    menu->addActions({m_record->toggle(), m_record->withLink(), m_markers->save()});
    menu->setToolTipsVisible(true);
    menu->addSeparator();
    menu->addActions(m_exportActions);
    menu->addSeparator();
    connect(addAction(menu, tr("&Quit"), Qt::CTRL | Qt::Key_Q, "quit"), &QAction::triggered, this,
        &QWidget::close);
}

void MainWindow::fillDeviceMenu(QMenu *menu)
{
    connect(addAction(menu, tr("&Connect or disconnect"), Qt::CTRL | Qt::Key_D, "connect"),
        &QAction::triggered, m_connectBar, &ConnectBar::connectOrDisconnect);
    connect(addAction(menu, tr("&Refresh the list of ports"), Qt::Key_F5, "refresh"),
        &QAction::triggered, m_connectBar, &ConnectBar::refreshPorts);
    menu->addSeparator();
    menu->addActions(m_tools->snapshotActions());
    menu->setToolTipsVisible(true);
    QMainWindow::addActions(m_tools->snapshotActions());
}

void MainWindow::fillScopeMenu(QMenu *menu)
{
    menu->addActions(m_page->moving());
    menu->addSeparator();
    menu->addActions(m_page->fitting());
    connect(addAction(menu, tr("&Earlier"), Qt::CTRL | Qt::Key_Left, "earlier"),
        &QAction::triggered, m_scope, [this] { m_scope->time().pan(-0.25); });
    connect(addAction(menu, tr("&Later"), Qt::CTRL | Qt::Key_Right, "later"), &QAction::triggered,
        m_scope, [this] { m_scope->time().pan(0.25); });
    for (const QList<QAction *> &group : m_page->tools().groups()) {
        menu->addSeparator();
        menu->addActions(group);
    }
    menu->addAction(m_searching->action());
    QMainWindow::addAction(m_searching->action());
    menu->addSeparator();
    menu->addAction(m_page->setPoints());
    menu->setToolTipsVisible(true);
    auto *ofFile = named(new TickMenu(tr("Signals of t&he file"), menu), "fileSignals");
    menu->addMenu(ofFile);
    connect(menu, &QMenu::aboutToShow, m_selection,
        [this, ofFile] { m_selection->fillFileSignals(*ofFile); });
    connect(named(addAction(menu, tr("R&oom for samples\u2026"), {}, "room"), "sampleRoom"),
        &QAction::triggered, this, &MainWindow::askForRoom);
    connect(named(addAction(menu, tr("&Clear what was recorded"), {}, "delete"), "clearRecorded"),
        &QAction::triggered, m_replacing, &Replacing::clear);
}

void MainWindow::fillEditMenu(QMenu *menu)
{
    const RegisterPanel::Actions &actions = m_registerPanel->actions();
    const QList<QAction *> groups[] = {{actions.undo, actions.redo},
        {actions.apply, actions.revert}, {actions.edit, actions.copy, actions.pin}};
    for (const QList<QAction *> &group : groups) {
        menu->addActions(group);
        menu->addSeparator();
        QMainWindow::addActions(group);
    }
    menu->setToolTipsVisible(true);
}

void MainWindow::fillViewMenu(QMenu *menu)
{
    menu->addActions(m_dockActions);
    connect(addAction(menu, tr("&Find a register"), Qt::CTRL | Qt::Key_K, "find"),
        &QAction::triggered, this, [this] {
            m_registerDock->show();
            m_registerPanel->focusSearch();
        });
    menu->addMenu(m_registerPanel->columnsMenu());
    QMenu *arrange = menu->addMenu(lineIcon("workspace"), tr("&Arrange for"));
    const std::pair<Workspaces::Arrangement, QString> ready[] = {
        {Workspaces::Arrangement::Tune, tr("&Tuning")},
        {Workspaces::Arrangement::Record, tr("&Recording")},
        {Workspaces::Arrangement::StartUp, tr("&Start-up")}};
    for (const auto &[arrangement, text] : ready)
        connect(arrange->addAction(text), &QAction::triggered, m_workspaces,
            [this, chosen = arrangement] { m_workspaces->arrange(chosen); });
    menu->addSeparator();
    fillThemes(menu->addMenu(lineIcon("theme"), tr("&Theme")));
    auto *numbers = named(addAction(menu, tr("Large &numbers"), Qt::Key_F9), "largeNumbers");
    numbers->setCheckable(true);
    // They take the place of the picture; everything around it stays.
    connect(numbers, &QAction::triggered, m_pages,
        [this](bool shown) { m_pages->setCurrentIndex(shown ? 1 : 0); });
    QAction *full = addAction(menu, tr("F&ull screen"), Qt::Key_F11);
    full->setCheckable(true);
    connect(
        full, &QAction::triggered, this, [this](bool on) { on ? showFullScreen() : showNormal(); });
}

void MainWindow::fillThemes(QMenu *menu)
{
    auto *group = new QActionGroup(this);
    const std::pair<Theme, QString> choices[] = {{Theme::System, tr("Like the &system")},
        {Theme::Light, tr("&Light")}, {Theme::Dark, tr("&Dark")}};
    for (const auto &[theme, text] : choices) {
        QAction *action = menu->addAction(text);
        action->setCheckable(true);
        action->setChecked(theme == m_settings.theme);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, chosen = theme] {
            m_settings.theme = chosen;
            applyTheme(chosen);
        });
    }
}

void MainWindow::fillMotorMenu(QMenu *menu)
{
    // The tab shows the key without taking it: Esc belongs to the Application, which sees it under dialogs too.
    connect(menu->addAction(lineIcon("stop"), tr("St&op motors") + QStringLiteral("\tEsc")),
        &QAction::triggered, &m_device, &Device::stop);
    menu->addSeparator();
    QAction *arm = menu->addAction(tr("A&rm"));
    arm->setCheckable(true);
    connect(arm, &QAction::triggered, m_control, [this, arm] {
        m_control->toggleArmed();
        arm->setChecked(m_device.armed());
    });
    connect(&m_device, &Device::armedStateChanged, arm, &QAction::setChecked);
    QAction *start = addAction(menu, tr("&Start"), Qt::CTRL | Qt::Key_Return, "start");
    start->setShortcuts({Qt::CTRL | Qt::Key_Return, Qt::CTRL | Qt::Key_Enter});
    start->setAutoRepeat(false);
    connect(start, &QAction::triggered, m_control, &ControlPanel::start);
    QAction *acknowledge =
        addAction(menu, tr("&Acknowledge faults"), Qt::CTRL | Qt::Key_Backspace, "acknowledge");
    acknowledge->setAutoRepeat(false);
    connect(acknowledge, &QAction::triggered, m_control, &ControlPanel::acknowledge);
    QAction *causes = menu->addAction(lineIcon("causes"), tr("&Faults and their causes\u2026"));
    causes->setObjectName(QStringLiteral("explainFaults"));
    connect(causes, &QAction::triggered, this, &MainWindow::explainFaults);
    menu->addSeparator();
    connect(menu->addAction(lineIcon("go"), tr("&Go to the set-point")), &QAction::triggered,
        m_control, &ControlPanel::go);
    connect(menu->addAction(lineIcon("stop-ramp"), tr("S&top the ramp")), &QAction::triggered,
        m_control, &ControlPanel::stopRamp);
    connect(menu, &QMenu::aboutToShow, this, [this, arm, start, acknowledge] {
        arm->setChecked(m_device.armed());
        const MotionAllowed allowed = armAllowed(m_device);
        arm->setEnabled(allowed.yes);
        arm->setToolTip(plainToolTip(allowed.why));
        start->setToolTip(plainToolTip(m_control->startHint()));
        acknowledge->setToolTip(plainToolTip(m_control->acknowledgeHint()));
    });
    menu->setToolTipsVisible(true);
}

} // namespace widgets
