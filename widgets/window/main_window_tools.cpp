// The tools of the main window: forms in docks below the scope, as tabs of one another, hidden until somebody asks.
#include "widgets/base/device_text.h"
#include "widgets/control/motion_log_panel.h"
#include "widgets/forms/form.h"
#include "widgets/forms/gains_form.h"
#include "widgets/forms/motor_form.h"
#include "widgets/forms/ramp_form.h"
#include "widgets/forms/rev_up_form.h"
#include "widgets/registers/register_panel.h"
#include "widgets/window/first_steps.h"
#include "widgets/window/main_window.h"

#include <QChildEvent>
#include <QDockWidget>
#include <QMenu>
#include <QScrollArea>
#include <QTabBar>
#include <QVBoxLayout>

#include <algorithm>

namespace widgets {
namespace {

constexpr double kToolShare = 0.48; ///< of the window's height, when the first tool is opened

} // namespace

void MainWindow::makeTools()
{
    // The control panel keeps its height: state and commands stay in view while something is tuned.
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    makeScopeTools();
    makeSnapshots();

    const RegisterPanel::Actions &actions = m_registerPanel->actions();
    auto *gains = new GainsForm(m_device, m_workbench.registers(), m_workbench.edits(),
        actions.apply, actions.revert, m_settings.inertias);
    connect(gains, &GainsForm::inertiaRemembered, this,
        [this](const QString &motor, double inertia) { m_settings.inertias[motor] = inertia; });
    addTool(gains, tr("Gains"), "gainsDock", Qt::CTRL | Qt::Key_1);
    addTool(new RevUpForm({m_device, m_workbench.registers(), m_workbench.edits(),
                m_workbench.capture(), m_files, actions.apply, actions.revert}),
        tr("Rev-up"), "revUpDock", Qt::CTRL | Qt::Key_2);
    m_ramps = new RampForm(m_device, m_workbench.registers(), m_workbench.motion());
    m_ramps->setPresets(m_settings.ramps);
    addTool(m_ramps, tr("Ramps"), "rampDock", Qt::CTRL | Qt::Key_3);
    addTool(new MotorForm(m_device, m_workbench.registers(), m_files), tr("Motor and drive"),
        "motorDock", Qt::CTRL | Qt::Key_4);

    auto *log = new MotionLogPanel(m_workbench.motionLog(), m_files);
    addTool(log, tr("Motion log"), "motionLogDock", Qt::CTRL | Qt::SHIFT | Qt::Key_L);
    connect(log, &MotionLogPanel::saved, this, [this](const QString &path) {
        m_told = Told::Other;
        m_banner->say(Banner::Kind::Note, tr("Exported to %1.").arg(deviceText(path)));
    });
}

QAction *MainWindow::addTool(
    Form *form, const QString &title, const char *name, const QKeySequence &keys)
{
    auto *scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(form);
    auto *dock = new QDockWidget(title, this);
    dock->setObjectName(QLatin1String(name));
    // Not floating: a window of its own would have to carry a stop button of its own.
    dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    auto *content = new QWidget(dock);
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(scroll, 1);
    if (QWidget *footer = form->footer()) {
        auto *below = new QHBoxLayout;
        below->setContentsMargins(8, 2, 8, 4);
        below->addWidget(footer);
        layout->addLayout(below);
    }
    dock->setWidget(content);
    addDockWidget(Qt::BottomDockWidgetArea, dock);
    if (!m_tools.isEmpty())
        tabifyDockWidget(m_tools.first(), dock);
    m_tools.append(dock);
    dock->hide();

    auto *open = new QAction(title, this);
    open->setShortcut(keys);
    open->setObjectName(QLatin1String(name) + QStringLiteral("Open"));
    m_toolActions.append(open);
    connect(open, &QAction::triggered, this, [this, dock, form] {
        const bool noneOpen = !anyToolOpen();
        dock->show();
        dock->raise();
        if (noneOpen)
            resizeDocks({dock}, {int(height() * kToolShare)}, Qt::Vertical);
        form->focusFirst();
    });

    WatchList &watch = m_workbench.watchList();
    watch.addSource([form] {
        return form->isVisible() ? form->watchedRegisters() : std::vector<catalog::RegisterId>();
    });
    connect(form, &Form::watchedRegistersChanged, &watch, &WatchList::changed);
    connect(dock, &QDockWidget::visibilityChanged, &watch, &WatchList::changed);
    connect(dock, &QDockWidget::visibilityChanged, this,
        [this] { m_firstSteps->setCrowded(anyToolOpen()); });
    connect(&m_workbench, &Workbench::heartbeat, form, [form](Milliseconds now) {
        if (form->isVisible())
            form->refresh(now);
    });
    connect(form, &Form::failed, this, [this](const QString &sentence) {
        m_told = Told::Other;
        m_banner->say(Banner::Kind::Warning, sentence);
    });
    return open;
}

bool MainWindow::anyToolOpen() const
{
    return std::any_of(
        m_tools.begin(), m_tools.end(), [](const auto *tool) { return !tool->isHidden(); });
}

/// Qt makes the tabs of docks when it needs them, and gives them no name.
void MainWindow::childEvent(QChildEvent *event)
{
    QMainWindow::childEvent(event);
    auto *tabs = qobject_cast<QTabBar *>(event->child());
    if (event->type() == QEvent::ChildPolished && tabs)
        tabs->setAccessibleName(tr("Tools"));
}

void MainWindow::fillToolsMenu(QMenu *menu)
{
    for (QAction *action : m_toolActions)
        QMainWindow::addAction(action);
    menu->addActions(m_toolActions);
}

} // namespace widgets
