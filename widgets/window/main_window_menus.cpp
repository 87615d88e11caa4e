// The menus of the main window: only entries that work, each key given once.
#include "widgets/base/device_text.h"
#include "widgets/base/theme.h"
#include "widgets/control/control_panel.h"
#include "widgets/control/motion_allowed.h"
#include "widgets/files/marker_file.h"
#include "widgets/files/record_control.h"
#include "widgets/registers/register_panel.h"
#include "widgets/scope/scope_tools.h"
#include "widgets/scope/scope_view.h"
#include "widgets/snapshots/snapshot_actions.h"
#include "widgets/window/about_dialog.h"
#include "widgets/window/connect_bar.h"
#include "widgets/window/first_steps.h"
#include "widgets/window/main_window.h"
#include "widgets/window/replacing.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QMenuBar>

namespace widgets {

QAction *MainWindow::addAction(QMenu *menu, const QString &text, const QKeySequence &keys)
{
    QAction *action = menu->addAction(text);
    action->setShortcut(keys);
    QMainWindow::addAction(action);
    return action;
}

void MainWindow::makeMenus(QMenuBar &bar)
{
    QMenu *file = bar.addMenu(tr("&File"));
    file->addActions({m_open, m_replayFile, m_import});
    file->addSeparator();
    file->addActions({m_record->toggle(), m_record->withLink(), m_markers->save()});
    file->setToolTipsVisible(true);
    file->addSeparator();
    file->addActions({m_export, m_copyPicture});
    file->addSeparator();
    connect(addAction(file, tr("&Quit"), Qt::CTRL | Qt::Key_Q), &QAction::triggered, this,
        &QWidget::close);

    fillEditMenu(bar.addMenu(tr("&Edit")));
    fillViewMenu(bar.addMenu(tr("&View")));

    QMenu *device = bar.addMenu(tr("&Device"));
    connect(addAction(device, tr("&Connect or disconnect"), Qt::CTRL | Qt::Key_D),
        &QAction::triggered, m_connectBar, &ConnectBar::connectOrDisconnect);
    connect(addAction(device, tr("&Refresh the list of ports"), Qt::Key_F5), &QAction::triggered,
        m_connectBar, &ConnectBar::refreshPorts);
    device->addSeparator();
    device->addActions(m_snapshots->actions());
    device->setToolTipsVisible(true);
    for (QAction *action : m_snapshots->actions())
        QMainWindow::addAction(action);

    fillMotorMenu(bar.addMenu(tr("&Motor")));

    QMenu *scope = bar.addMenu(tr("&Scope"));
    scope->addActions({m_run, m_follow});
    scope->addSeparator();
    scope->addActions({m_fit, m_fitValues, m_zoomIn, m_zoomOut});
    connect(addAction(scope, tr("&Earlier"), Qt::CTRL | Qt::Key_Left), &QAction::triggered, m_scope,
        [this] { m_scope->pan(-0.25); });
    connect(addAction(scope, tr("&Later"), Qt::CTRL | Qt::Key_Right), &QAction::triggered, m_scope,
        [this] { m_scope->pan(0.25); });
    for (const QList<QAction *> &group : m_scopeTools->groups()) {
        scope->addSeparator();
        scope->addActions(group);
    }
    scope->addSeparator();
    m_fileSignals = scope->addMenu(tr("Signals of the &file"));
    m_fileSignals->setObjectName(QStringLiteral("fileSignals"));
    connect(scope, &QMenu::aboutToShow, this, &MainWindow::fillFileSignals);
    QAction *room = addAction(scope, tr("R&oom for samples\u2026"));
    room->setObjectName(QStringLiteral("sampleRoom"));
    connect(room, &QAction::triggered, this, &MainWindow::askForRoom);
    QAction *clear = addAction(scope, tr("&Clear what was recorded"));
    clear->setObjectName(QStringLiteral("clearRecorded"));
    connect(clear, &QAction::triggered, m_replacing, &Replacing::clear);

    fillToolsMenu(bar.addMenu(tr("&Tools")));

    QMenu *help = bar.addMenu(tr("&Help"));
    connect(addAction(help, tr("&First steps")), &QAction::triggered, m_firstSteps,
        &FirstSteps::restart);
    connect(addAction(help, tr("&Keys"), Qt::Key_F1), &QAction::triggered, this,
        [this] { showKeys(this); });
    connect(addAction(help, tr("&About Rotorscope")), &QAction::triggered, this,
        [this] { showAbout(this); });
}

void MainWindow::fillEditMenu(QMenu *menu)
{
    const RegisterPanel::Actions &actions = m_registerPanel->actions();
    const QList<QAction *> groups[] = {{actions.undo, actions.redo},
        {actions.apply, actions.revert}, {actions.edit, actions.copy, actions.pin}};
    for (const QList<QAction *> &group : groups) {
        menu->addActions(group);
        menu->addSeparator();
        for (QAction *action : group)
            QMainWindow::addAction(action);
    }
    menu->setToolTipsVisible(true);
}

void MainWindow::fillViewMenu(QMenu *menu)
{
    menu->addActions(m_dockActions);
    connect(addAction(menu, tr("&Find a register"), Qt::CTRL | Qt::Key_K), &QAction::triggered,
        this, [this] {
            m_registerDock->show();
            m_registerPanel->focusSearch();
        });
    menu->addMenu(m_registerPanel->columnsMenu());
    menu->addSeparator();
    QMenu *themes = menu->addMenu(tr("&Theme"));
    auto *group = new QActionGroup(this);
    const std::pair<Theme, QString> choices[] = {{Theme::System, tr("Like the &system")},
        {Theme::Light, tr("&Light")}, {Theme::Dark, tr("&Dark")}};
    for (const auto &[theme, text] : choices) {
        QAction *action = themes->addAction(text);
        action->setCheckable(true);
        action->setChecked(theme == m_settings.theme);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, chosen = theme] {
            m_settings.theme = chosen;
            applyTheme(chosen);
        });
    }
    QAction *numbers = addAction(menu, tr("Large &numbers"), Qt::Key_F9);
    numbers->setObjectName(QStringLiteral("largeNumbers"));
    numbers->setCheckable(true);
    connect(numbers, &QAction::triggered, this, &MainWindow::showBigNumbers);
    QAction *full = addAction(menu, tr("F&ull screen"), Qt::Key_F11);
    full->setCheckable(true);
    connect(
        full, &QAction::triggered, this, [this](bool on) { on ? showFullScreen() : showNormal(); });
}

void MainWindow::fillMotorMenu(QMenu *menu)
{
    // The tab shows the key without taking it: Esc belongs to the Application, which sees it under dialogs too.
    connect(menu->addAction(tr("St&op motors") + QStringLiteral("\tEsc")), &QAction::triggered,
        &m_device, &Device::stop);
    menu->addSeparator();
    QAction *arm = menu->addAction(tr("A&rm"));
    arm->setCheckable(true);
    connect(arm, &QAction::triggered, m_control, [this, arm] {
        m_control->toggleArmed();
        arm->setChecked(m_device.armed());
    });
    connect(&m_device, &Device::armedStateChanged, arm, &QAction::setChecked);
    QAction *start = addAction(menu, tr("&Start"), Qt::CTRL | Qt::Key_Return);
    start->setShortcuts({Qt::CTRL | Qt::Key_Return, Qt::CTRL | Qt::Key_Enter});
    start->setAutoRepeat(false);
    connect(start, &QAction::triggered, m_control, &ControlPanel::start);
    QAction *acknowledge = addAction(menu, tr("&Acknowledge faults"), Qt::CTRL | Qt::Key_Backspace);
    acknowledge->setAutoRepeat(false);
    connect(acknowledge, &QAction::triggered, m_control, &ControlPanel::acknowledge);
    menu->addSeparator();
    connect(menu->addAction(tr("&Go to the set-point")), &QAction::triggered, m_control,
        &ControlPanel::go);
    connect(menu->addAction(tr("S&top the ramp")), &QAction::triggered, m_control,
        &ControlPanel::stopRamp);
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
