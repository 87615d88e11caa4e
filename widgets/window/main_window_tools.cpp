// The tools of the main window: forms in docks below the scope, as tabs of one another, hidden until somebody asks. A
// form is made when it is first seen, when a board is to come, or when the window is painted and nothing else is to be done.
#include "widgets/base/device_text.h"
#include "widgets/base/form.h"
#include "widgets/control/motion_log_panel.h"
#include "widgets/forms/gains_form.h"
#include "widgets/forms/motor_form.h"
#include "widgets/forms/ramp_form.h"
#include "widgets/forms/rev_up_form.h"
#include "widgets/registers/register_panel.h"
#include "widgets/window/connect_bar.h"
#include "widgets/window/first_steps.h"
#include "widgets/window/main_window.h"

#include <QChildEvent>
#include <QDockWidget>
#include <QMenu>
#include <QScrollArea>
#include <QTabBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <utility>

namespace widgets {
namespace {

constexpr std::chrono::milliseconds kSettled(100); ///< after the first picture, before the tools

} // namespace

void MainWindow::makeTools()
{
    // The control panel keeps its height: state and commands stay in view while something is tuned.
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    makeScopeTools();
    makeSnapshots();

    addTool(tr("Gains"), "gainsDock", Qt::CTRL | Qt::Key_1, [this] {
        const RegisterPanel::Actions &actions = m_registerPanel->actions();
        auto *gains = new GainsForm(m_device, m_workbench.registers(), m_workbench.edits(),
            actions.apply, actions.revert, m_settings.inertias);
        connect(gains, &GainsForm::inertiaRemembered, this,
            [this](const QString &motor, double inertia) { m_settings.inertias[motor] = inertia; });
        return gains;
    });
    addTool(tr("Rev-up"), "revUpDock", Qt::CTRL | Qt::Key_2, [this] {
        const RegisterPanel::Actions &actions = m_registerPanel->actions();
        return new RevUpForm({m_device, m_workbench.registers(), m_workbench.edits(),
            m_workbench.capture(), m_files, actions.apply, actions.revert});
    });
    addTool(tr("Ramps"), "rampDock", Qt::CTRL | Qt::Key_3, [this] {
        m_ramps = new RampForm(m_device, m_workbench.registers(), m_workbench.motion());
        m_ramps->setPresets(m_settings.ramps);
        return m_ramps;
    });
    addTool(tr("Motor and drive"), "motorDock", Qt::CTRL | Qt::Key_4,
        [this] { return new MotorForm(m_device, m_workbench.registers(), m_files); });
    addTool(tr("Motion log"), "motionLogDock", Qt::CTRL | Qt::SHIFT | Qt::Key_L, [this] {
        auto *log = new MotionLogPanel(m_workbench.motionLog(), m_files);
        connect(log, &MotionLogPanel::saved, this, [this](const QString &path) {
            say(Banner::Kind::Note, tr("Exported to %1.").arg(deviceText(path)));
        });
        return log;
    });
    // A form is to see a board come: it does not ask what came before it.
    connect(&m_device, &Device::openWished, this, &MainWindow::finishTools);
}

QAction *MainWindow::addTool(const QString &title, const char *name, const QKeySequence &keys,
    std::function<Form *()> makeForm)
{
    auto *dock = new QDockWidget(title, this);
    dock->setObjectName(QLatin1String(name));
    // Not floating: a window of its own would have to carry a stop button of its own.
    dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    addDockWidget(Qt::BottomDockWidgetArea, dock);
    if (!m_tools.empty())
        tabifyDockWidget(m_tools.front().dock, dock);
    m_tools.push_back({dock, std::move(makeForm)});
    dock->hide();

    auto *open = new QAction(title, this);
    open->setShortcut(keys);
    open->setObjectName(QLatin1String(name) + QStringLiteral("Open"));
    m_toolActions.append(open);
    const std::size_t index = m_tools.size() - 1;
    connect(open, &QAction::triggered, this, [this, dock, index] {
        const bool noneOpen = !anyToolOpen();
        Form *form = formOf(m_tools[index]);
        dock->show();
        dock->raise();
        if (noneOpen)
            resizeDocks({dock}, {int(height() * form->heightShare())}, Qt::Vertical);
        form->focusFirst();
    });
    WatchList &watch = m_workbench.watchList();
    connect(dock, &QDockWidget::visibilityChanged, &watch, &WatchList::changed);
    connect(dock, &QDockWidget::visibilityChanged, this, [this, index] {
        if (!m_tools[index].dock->isHidden())
            formOf(m_tools[index]);
        m_firstSteps->setCrowded(anyToolOpen());
    });
    return open;
}

Form *MainWindow::formOf(Tool &tool)
{
    if (tool.form)
        return tool.form;
    auto *content = new QWidget(tool.dock);
    auto *scroll = new QScrollArea(content);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    Form *form = tool.form = tool.make();
    scroll->setWidget(form);
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
    tool.dock->setWidget(content);
    content->show(); // which a dock that is open already leaves to us

    WatchList &watch = m_workbench.watchList();
    watch.addSource([form] {
        return form->isVisible() ? form->watchedRegisters() : std::vector<catalog::RegisterId>();
    });
    connect(form, &Form::watchedRegistersChanged, &watch, &WatchList::changed);
    connect(&m_workbench, &Workbench::heartbeat, form, [form](Milliseconds now) {
        if (form->isVisible())
            form->refresh(now);
    });
    connect(form, &Form::failed, this,
        [this](const QString &sentence) { say(Banner::Kind::Warning, sentence); });
    return form;
}

void MainWindow::finishTools()
{
    for (Tool &tool : m_tools)
        formOf(tool);
}

void MainWindow::makeNextTool()
{
    const auto next = std::find_if(
        m_tools.begin(), m_tools.end(), [](const Tool &tool) { return tool.form == nullptr; });
    if (next == m_tools.end())
        return;
    formOf(*next);
    QTimer::singleShot(0, this, &MainWindow::makeNextTool);
}

void MainWindow::paintEvent(QPaintEvent *event)
{
    QMainWindow::paintEvent(event);
    if (std::exchange(m_painted, true))
        return;
    QTimer::singleShot(kSettled, this, [this] {
        m_connectBar->refreshPorts();
        Q_EMIT settled();
        makeNextTool();
    });
}

bool MainWindow::anyToolOpen() const
{
    return std::any_of(
        m_tools.begin(), m_tools.end(), [](const Tool &tool) { return !tool.dock->isHidden(); });
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
