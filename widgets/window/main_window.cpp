#include "widgets/window/main_window.h"

#include "session/files/whole_file.h"
#include "widgets/base/banner.h"
#include "widgets/base/device_text.h"
#include "widgets/base/file_prompt.h"
#include "widgets/base/flow_layout.h"
#include "widgets/base/lamp.h"
#include "widgets/base/messages.h"
#include "widgets/base/replaying.h"
#include "widgets/control/big_numbers.h"
#include "widgets/control/control_panel.h"
#include "widgets/control/current_scale_dialog.h"
#include "widgets/control/current_scales.h"
#include "widgets/control/limits_dialog.h"
#include "widgets/control/motion_question.h"
#include "widgets/control/motor_button.h"
#include "widgets/control/stop_alarm.h"
#include "widgets/files/event_recorder.h"
#include "widgets/files/export_dialog.h"
#include "widgets/files/record_control.h"
#include "widgets/files/replay_bar.h"
#include "widgets/files/sample_room.h"
#include "widgets/forms/ramp_form.h"
#include "widgets/measuring/math_channels.h"
#include "widgets/registers/register_panel.h"
#include "widgets/scope/cursor_panel.h"
#include "widgets/scope/scope_tools.h"
#include "widgets/scope/scope_view.h"
#include "widgets/scope/signals/channel_strip.h"
#include "widgets/scope/trigger/trigger_bar.h"
#include "widgets/scope/trigger/trigger_control.h"
#include "widgets/snapshots/snapshot_panel.h"
#include "widgets/window/application.h"
#include "widgets/window/connect_bar.h"
#include "widgets/window/first_steps.h"
#include "widgets/window/leaving.h"
#include "widgets/window/shortcut_guard.h"
#include "widgets/window/status_strip.h"
#include "widgets/window/tab_order.h"

#include <QDockWidget>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QPainter>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace widgets {
namespace {

constexpr int kRegisterWidth = 304;
constexpr int kRegisterMinimum = 240;
constexpr int kControlWidth = 268;
constexpr int kCrowdedHeight =
    480; ///< of plots and what is around them, when cursors are read as well
constexpr int kLayoutVersion = 1;

/// A green disc while the picture runs, a red square while it is held: told apart by shape, too.
QIcon runIcon(bool running, bool live, const QPalette &palette)
{
    const Lamp::Light moving = live ? Lamp::Light::On : Lamp::Light::Off;
    QPixmap pixmap(32, 32);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Lamp::colorOf(running ? moving : Lamp::Light::Bad, palette));
    if (running)
        painter.drawEllipse(QRectF(5, 5, 22, 22));
    else
        painter.drawRect(QRectF(6, 6, 20, 20));
    return QIcon(pixmap);
}

/// What is switched on has to be told from what is not in both themes; the style's sunken look is too faint for that.
QString scopeBarStyle(const QPalette &palette)
{
    return QStringLiteral("QToolButton { padding: 3px 9px; border: 1px solid %1; border-radius: "
                          "4px; background: %2; }"
                          "QToolButton:hover { background: %3; }"
                          "QToolButton:checked { background: %4; border-color: %5; }"
                          "QToolButton:focus { border-color: %5; }")
        .arg(palette.color(QPalette::Mid).name(), palette.color(QPalette::Button).name(),
            palette.color(QPalette::Base).name(), palette.color(QPalette::Mid).name(),
            palette.color(QPalette::Highlight).name());
}

} // namespace

MainWindow::MainWindow(Workbench &workbench, const session::PortSource &ports, FilePrompt &files,
    const Settings &settings, QWidget *parent)
    : QMainWindow(parent)
    , m_workbench(workbench)
    , m_device(workbench.device())
    , m_files(files)
    , m_settings(settings)
    , m_scope(new ScopeView(workbench.capture(), workbench.events(), this))
    , m_selection(new SignalSelection(
          m_device, workbench.capture(), workbench.signalPlan(), *m_scope, this))
    , m_math(workbench.math())
    , m_trigger(new TriggerControl(workbench.trigger(), *m_scope, workbench.capture(), this))
    , m_connectBar(new ConnectBar(m_device, ports, this))
    , m_alarm(new StopAlarm(this))
    , m_leaving(new Leaving(
          m_device, [&workbench] { return workbench.sessionTime(); }, m_questions, this))
{
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(QStringLiteral("Rotorscope"));
    new ShortcutGuard(this);
    m_workbench.registers().setPinned(settings.pinned);
    m_device.setUserLimits({settings.maxSpeedRpm, settings.maxCurrentAmps});
    m_connectBar->setEndpoint(settings.port, settings.baud);
    m_connectBar->setProtocol(settings.protocol);

    makeScopeActions();
    makeRecording();
    setCentralWidget(makeCentre());
    makeDocks();
    makeTools();
    setStatusBar(m_status = new StatusStrip(m_device, this));
    setMenuWidget(makeTop());
    connectParts();
    orderTabs(*this, {menuWidget(), m_registerDock, m_control});

    resize(1280, 720);
    if (!settings.geometry.isEmpty())
        restoreGeometry(settings.geometry);
    if (!settings.layout.isEmpty())
        restoreState(settings.layout, kLayoutVersion);
    for (Tool &tool : m_tools) {
        if (!tool.dock->isHidden())
            formOf(tool);
    }
    if (!settings.firstStepsDone)
        m_firstSteps->restart();
}

MainWindow::~MainWindow()
{
    // An open tool tells that it goes, when the members that would hear it are gone already.
    for (const Tool &tool : m_tools)
        tool.dock->disconnect(this);
}

Settings MainWindow::settings() const
{
    Settings now = m_settings;
    now.geometry = saveGeometry();
    now.layout = saveState(kLayoutVersion);
    now.port = m_connectBar->path();
    if (m_connectBar->baud() > 0)
        now.baud = m_connectBar->baud();
    now.protocol = m_connectBar->protocol();
    now.maxSpeedRpm = m_device.userLimits().maxSpeedRpm;
    now.maxCurrentAmps = m_device.userLimits().maxCurrentAmps;
    now.pinned = m_workbench.registers().pinned();
    now.registerColumns = m_registerPanel->columns();
    if (m_snapshotPanel)
        now.snapshotFolder = m_snapshotPanel->folder();
    if (m_ramps)
        now.ramps = m_ramps->presets();
    now.samplesOnDiskGB = m_room->wanted();
    now.recordFolder = m_record->folder();
    now.formulas = m_math.formulas();
    now.traceColors = m_scope->chosenColors();
    return now;
}

QWidget *MainWindow::makeTop()
{
    auto *top = new QWidget(this);
    auto *bar = new QMenuBar(top);
    auto *strip = new QWidget(top);
    auto *stop = new StopButton(strip);
    stop->setObjectName(QStringLiteral("stopMotors"));
    connect(stop, &StopButton::stopPressed, &m_device, &Device::stop);
    auto *application = qobject_cast<Application *>(QCoreApplication::instance());
    Q_ASSERT(application); // without it Esc would not stop
    connect(application, &Application::stopPressed, this, [this] { m_device.stop(); });

    auto *stripLayout = new QHBoxLayout(strip);
    stripLayout->setContentsMargins(8, 5, 8, 5);
    stripLayout->setSpacing(12);
    stripLayout->addWidget(m_connectBar, 1);
    stripLayout->addWidget(stop);

    m_frame = new QWidget(top);
    m_frame->setFixedHeight(3);
    m_frame->setAutoFillBackground(true);
    // Over the plots: what one is about to click stays where it is.
    m_banner = new Banner(m_scope->findChild<QWidget *>(QStringLiteral("scopePlot")), this);

    auto *layout = new QVBoxLayout(top);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(strip);
    layout->addWidget(m_frame);
    makeMenus(*bar);
    updateFrame();
    return top;
}

void MainWindow::makeScopeActions()
{
    const auto make = [this](const QString &text, const QKeySequence &keys, auto slot) {
        auto *action = new QAction(text, this);
        action->setShortcut(keys);
        QMainWindow::addAction(action);
        connect(action, &QAction::triggered, m_scope, slot);
        return action;
    };
    m_run = make(tr("Run", "the scope's picture moves"), Qt::Key_Space, &ScopeView::setRunning);
    m_run->setObjectName(QStringLiteral("scopeRun"));
    m_run->setCheckable(true);
    m_run->setChecked(m_scope->running());
    m_run->setToolTip(tr("Lets the picture run or holds it; recording goes on (Space)"));
    m_follow = make(tr("Follow"), Qt::Key_End, &ScopeView::setFollowing);
    m_follow->setCheckable(true);
    m_follow->setChecked(m_scope->following());
    m_follow->setToolTip(tr("Keeps the newest samples in view (End)"));
    m_fit = make(tr("Fit", "show all samples"), Qt::Key_F, &ScopeView::fitAll);
    m_fit->setToolTip(tr("Shows everything (F)"));
    m_fitValues = make(tr("Fit values"), Qt::SHIFT | Qt::Key_F, &ScopeView::fitValues);
    m_fitValues->setToolTip(tr("Fits the value axes only (Shift+F)"));
    m_zoomIn = make(tr("Zoom in"), Qt::Key_Plus, [this] { m_scope->zoom(2.0); });
    m_zoomIn->setToolTip(tr("Shows half the time (+)"));
    m_zoomOut = make(tr("Zoom out"), Qt::Key_Minus, [this] { m_scope->zoom(0.5); });
    m_zoomOut->setToolTip(tr("Shows twice the time (\u2212)"));
    // The bar has little room, and less in other languages; menus and screen readers get the words.
    m_fitValues->setIconText(QStringLiteral("\u2195"));
    m_zoomIn->setIconText(QStringLiteral("+"));
    m_zoomOut->setIconText(QStringLiteral("\u2212"));
    connect(m_scope, &ScopeView::runningChanged, this, &MainWindow::showRunning);
    connect(
        m_selection, &SignalSelection::changed, this, [this] { showRunning(m_scope->running()); });
    showRunning(m_scope->running());
    connect(m_scope, &ScopeView::followingChanged, m_follow, &QAction::setChecked);
    m_scopeTools = new ScopeTools(*m_scope, *m_trigger, *this);
}

/// Where the samples of the picture come from.
QString MainWindow::sourceText() const
{
    if (m_device.answering())
        return replaying(m_device) ? tr("Replay", "the scope shows it")
                                   : tr("Live", "the scope's picture moves");
    return m_workbench.signalPlan().showsFile() ? tr("File", "the scope shows it")
                                                : tr("Run", "the scope's picture moves");
}

void MainWindow::showRunning(bool running)
{
    m_run->setChecked(running);
    m_run->setText(!running ? tr("Held", "the scope's picture stands still") : sourceText());
    m_run->setIcon(runIcon(running, m_device.answering(), palette()));
}

void MainWindow::changeEvent(QEvent *event)
{
    QMainWindow::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || !m_scopeBar)
        return;
    showRunning(m_scope->running());
    m_scopeBar->setStyleSheet(scopeBarStyle(palette()));
    updateFrame();
}

QWidget *MainWindow::makeScopeBar()
{
    auto *bar = new QWidget(this);
    m_scopeBar = bar;
    bar->setStyleSheet(scopeBarStyle(palette()));
    auto *layout = new QHBoxLayout(bar);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(4);
    auto *buttons = new QWidget(bar); // two lines where the words are long and the screen is small
    auto *flow = new FlowLayout(4, buttons);
    for (QAction *action :
        {m_run, m_follow, m_fit, m_fitValues, m_zoomIn, m_zoomOut, m_scopeTools->cursors()}) {
        auto *button = new QToolButton(bar);
        button->setDefaultAction(action);
        button->setToolButtonStyle(
            action == m_run ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonTextOnly);
        button->setFocusPolicy(Qt::TabFocus);
        button->setMinimumHeight(26);
        button->setAccessibleName(action->text());
        connect(action, &QAction::changed, button,
            [button, action] { button->setAccessibleName(action->text()); });
        flow->addWidget(button);
    }
    layout->addWidget(buttons, 1);
    auto *record = new QToolButton(bar);
    record->setDefaultAction(m_record->toggle());
    record->setFocusPolicy(Qt::TabFocus);
    record->setMinimumHeight(26);
    record->setAccessibleName(tr("Record to disk"));
    layout->addWidget(record, 0, Qt::AlignTop);
    auto *save = new QToolButton(bar);
    m_export = new QAction(tr("&Export\u2026"), this);
    m_export->setIconText(tr("Export\u2026"));
    m_export->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_E);
    m_export->setToolTip(tr("Writes samples or a picture to a file (Ctrl+Shift+E)"));
    QMainWindow::addAction(m_export);
    connect(m_export, &QAction::triggered, this, &MainWindow::exportCsv);
    save->setDefaultAction(m_export);
    save->setFocusPolicy(Qt::TabFocus);
    save->setMinimumHeight(26);
    save->setAccessibleName(tr("Export"));
    layout->addWidget(save, 0, Qt::AlignTop);
    return bar;
}

QWidget *MainWindow::makeCentre()
{
    auto *centre = new QWidget(this);
    m_firstSteps = new FirstSteps(m_device, centre);
    auto *picture = new QWidget(centre);
    auto *layout = new QVBoxLayout(picture);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(makeScopeBar());
    layout->addWidget(m_record->line());
    layout->addWidget(new ReplayBar(m_device, m_workbench.replay(), centre));
    auto *trigger = new TriggerBar(*m_trigger, *m_scope, centre);
    layout->addWidget(trigger);
    connect(&m_workbench, &Workbench::heartbeat, trigger, &TriggerBar::refreshAge);
    layout->addWidget(m_scope, 1);
    // Made when cursors are first shown.
    connect(
        &m_scope->cursors(), &Cursors::changed, picture,
        [this, picture, layout, place = layout->count()] {
            auto *panel = new CursorPanel(*m_scope, m_workbench.capture(), picture);
            layout->insertWidget(place, panel);
            panel->tabAfterScope();
        },
        Qt::SingleShotConnection);
    auto *strip = new ChannelStrip(*m_selection, m_device, centre);
    layout->addWidget(strip);
    connect(&m_workbench, &Workbench::heartbeat, strip, &ChannelStrip::measure);
    strip->foldWhen([this, picture] {
        return m_scope->cursors().visible() && picture->height() < kCrowdedHeight;
    });
    connect(&m_scope->cursors(), &Cursors::changed, strip, &ChannelStrip::room);
    connect(m_scope, &ScopeView::drawn, strip, &ChannelStrip::room);
    m_bigNumbers = new BigNumbers(m_device, m_workbench.registers(), centre);
    m_pages = new QStackedWidget(centre);
    m_pages->addWidget(picture);
    m_pages->addWidget(m_bigNumbers);
    auto *pages = new QVBoxLayout(centre);
    pages->setContentsMargins(0, 0, 0, 0);
    pages->setSpacing(0);
    pages->addWidget(m_firstSteps);
    pages->addWidget(m_pages, 1);
    m_scope->setMinimumSize(320, 160);
    return centre;
}

void MainWindow::makeDocks()
{
    m_registerPanel = new RegisterPanel(m_workbench.registers(), m_workbench.edits(), this);
    m_registerPanel->setMinimumWidth(kRegisterMinimum);
    m_registerPanel->setColumns(m_settings.registerColumns);
    m_control = new ControlPanel(m_device, m_workbench.registers(), m_workbench.motion(), this);

    const auto dock = [this](const QString &title, const char *name, QWidget *content,
                          Qt::DockWidgetArea area) {
        auto *widget = new QDockWidget(title, this);
        widget->setObjectName(QLatin1String(name));
        // Not floating: a window of its own would have to carry a stop button of its own.
        widget->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
        widget->setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
        widget->setWidget(content);
        addDockWidget(area, widget);
        m_dockActions.append(widget->toggleViewAction());
        return widget;
    };
    m_registerDock = dock(tr("Registers"), "registerDock", m_registerPanel, Qt::LeftDockWidgetArea);
    auto *right = dock(tr("Control"), "controlDock", m_control, Qt::RightDockWidgetArea);
    resizeDocks({m_registerDock, right},
        {kRegisterWidth, std::max(kControlWidth, m_control->minimumSizeHint().width())},
        Qt::Horizontal);
}

void MainWindow::connectParts()
{
    const auto note = [this](const QString &sentence) {
        m_told = Told::Other;
        m_banner->say(Banner::Kind::Warning, sentence);
    };
    connect(m_connectBar, &ConnectBar::refused, this, note);
    connect(&m_device, &Device::interrupted, this,
        [note](const session::Interruption &what) { note(interruptionText(what)); });
    connect(&m_workbench.motion(), &MotionGate::failed, this, note);
    showMotionQuestions(m_workbench.motion(), m_device, this);
    connect(m_control, &ControlPanel::limitsWanted, this, &MainWindow::askForLimits);
    m_scales = new CurrentScales(m_device, m_settings.currentScales, this);
    connect(m_scales, &CurrentScales::told, this, note);
    connect(m_control, &ControlPanel::currentScaleWanted, this, &MainWindow::askForCurrentScale);
    connect(&m_workbench.signalPlan(), &SignalPlan::failed, this, note);
    connect(&m_workbench.signalPlan(), &SignalPlan::noticed, this, note);
    connect(m_selection, &SignalSelection::noticed, this, note);
    connect(m_registerPanel, &RegisterPanel::registersChosen, m_selection,
        [this](const QList<quint32> &ids) {
            for (const quint32 id : ids)
                m_selection->add(id);
        });
    connect(m_firstSteps, &FirstSteps::simulatorWanted, m_connectBar, &ConnectBar::openSimulator);
    connect(m_firstSteps, &FirstSteps::boardWanted, m_connectBar, &ConnectBar::focusPort);
    connect(m_firstSteps, &FirstSteps::exportWanted, this, &MainWindow::exportCsv);
    connect(
        m_firstSteps, &FirstSteps::finished, this, [this] { m_settings.firstStepsDone = true; });

    WatchList &watch = m_workbench.watchList();
    watch.addSource([this] { return m_control->watchedRegisters(); });
    watch.addSource([this] { return m_bigNumbers->watchedRegisters(); });
    watch.addSource([this] { return m_registerPanel->visibleRegisters(); });
    connect(m_bigNumbers, &BigNumbers::watchedRegistersChanged, &watch, &WatchList::changed);
    connect(m_control, &ControlPanel::watchedRegistersChanged, &watch, &WatchList::changed);
    connect(m_registerPanel, &RegisterPanel::visibleRegistersChanged, &watch, &WatchList::changed);

    connect(&m_workbench, &Workbench::heartbeat, m_control, &ControlPanel::refresh);
    connect(&m_workbench, &Workbench::heartbeat, m_status, &StatusStrip::refresh);
    connect(m_room, &SampleRoom::refreshed, m_status, &StatusStrip::showHeld);
    connect(&m_workbench, &Workbench::advanced, m_scope, &ScopeView::captureChanged);
    connect(&m_workbench, &Workbench::heartbeat, this, &MainWindow::tellReleased);
    connect(&m_device, &Device::linkStateChanged, this, &MainWindow::linkChanged);
    connect(&m_device, &Device::portStateChanged, this, &MainWindow::portChanged);
    connect(&m_device, &Device::armedStateChanged, this, &MainWindow::updateFrame);
    connect(&m_device, &Device::stopAdvanced, this, &MainWindow::stopAdvanced);
    connect(&m_device, &Device::stopsWanted, this, [this](const QStringList &ports) {
        if (!m_leaving->underWay())
            m_alarm->showWanted(ports);
    });
    connect(m_alarm, &StopAlarm::takenBack, &m_device, &Device::forgetStop);
    connect(&m_device, &Device::stopImpossible, this, [this] {
        if (m_told == Told::Loss && m_leaving->mayTurn() && !m_alarm->isVisible()
            && !m_leaving->underWay())
            m_alarm->raiseNotSent();
    });
    connect(m_connectBar, &ConnectBar::disconnectWanted, this,
        [this] { m_leaving->beforeDisconnecting([this] { m_connectBar->disconnectNow(); }); });
    connect(m_leaving, &Leaving::said, this, &MainWindow::warn);
}

void MainWindow::linkChanged()
{
    tellLink();
    updateFrame();
    // What is shown of a board that does not answer must not be taken for the present.
    const bool expected = m_device.portOpen() || m_told == Told::Loss;
    const bool stale = m_device.identified() && !m_device.answering() && expected;
    m_scope->setStale(stale ? tr("Not live: %1", "state of the link, e.g. board silent")
                                  .arg(linkStateText(m_device.link().state))
                            : QString());
    showRunning(m_scope->running()); // its lamp is lit while samples can come
}

/// What was done before a connection is no news beside what comes now.
void MainWindow::portChanged()
{
    if (m_device.portOpen() && m_told == Told::Done) {
        m_banner->clear();
        m_told = Told::Other;
    }
    linkChanged();
}

void MainWindow::tellLink()
{
    const LinkMessage message = linkMessage();
    // Contact that was lost stays told until there is contact again, not until the next attempt.
    const bool stillLost = m_told == Told::Loss && m_device.identified() && !m_device.answering()
        && m_connectBar->connecting();
    const bool notOfTheLink = m_told == Told::Other || m_told == Told::Done;
    if (!message.sentence.isEmpty())
        m_banner->say(message.kind, message.sentence);
    else if (stillLost || notOfTheLink)
        return;
    else
        m_banner->clear();
    m_told = message.told;
}

MainWindow::LinkMessage MainWindow::linkMessage() const
{
    using drive::LinkState;
    const session::PortError error = m_device.portError();
    const drive::LinkChanged link = m_device.link();
    const bool known = m_device.identified().has_value();
    if (!m_device.portOpen() && error.problem != session::PortProblem::None) {
        const bool lost = error.problem == session::PortProblem::Unplugged
            || error.problem == session::PortProblem::TakenOver;
        return {Banner::Kind::Bad, portProblemText(error, m_device.endpoint().path),
            lost ? Told::Loss : Told::Link};
    }
    if (link.state == LinkState::Lost && known)
        return {Banner::Kind::Bad,
            linkLostText(m_device.identified()->identity.watchdog) + QLatin1Char(' ')
                + linkReasonText(link.reason),
            Told::Loss};
    if (link.state == LinkState::Lost)
        return {Banner::Kind::Bad, linkReasonText(link.reason), Told::Link};
    if (link.state == LinkState::Connecting && link.reason != drive::LinkReason::None)
        return {Banner::Kind::Note, linkReasonText(link.reason), Told::Link};
    if (link.reason == drive::LinkReason::BoardReset && link.state == LinkState::Connected)
        return {Banner::Kind::Warning, linkReasonText(link.reason), Told::Link};
    if (known && m_device.answering() && !m_device.identified()->identity.knownFirmware)
        return {Banner::Kind::Note,
            tr("This firmware is not known: registers are shown raw and nothing is written."),
            Told::Link};
    return {};
}

void MainWindow::updateFrame()
{
    const bool real =
        m_device.portOpen() && m_device.endpoint().kind == session::Endpoint::Kind::Serial;
    QPalette colors = palette();
    colors.setColor(QPalette::Window,
        real && m_device.armed() ? QColor(0xc0, 0x1f, 0x1f) : palette().color(QPalette::Mid));
    m_frame->setPalette(colors);
    m_frame->setFixedHeight(real && m_device.armed() ? 3 : 1);
    QString title = QStringLiteral("Rotorscope");
    if (m_device.portOpen())
        title = tr("%1 \u2013 Rotorscope", "what is connected")
                    .arg(real ? deviceText(m_device.endpoint().path)
                            : replaying(m_device)
                            ? tr("Replay of %1")
                                  .arg(deviceText(QFileInfo(m_device.endpoint().path).fileName()))
                            : tr("Simulated board"));
    setWindowTitle(title);
}

void MainWindow::stopAdvanced(const drive::StopProgress &progress)
{
    if (progress.word == drive::StopWord::NotConfirmed && !m_leaving->underWay())
        m_alarm->raiseAlarm(progress.motor);
    else
        m_alarm->take(progress);
}

void MainWindow::warn(const QString &sentence) { say(Banner::Kind::Warning, sentence); }

void MainWindow::askForLimits()
{
    auto *dialog = new LimitsDialog(m_device.userLimits(), this);
    connect(dialog, &LimitsDialog::chosen, &m_device, &Device::setUserLimits);
    dialog->open();
}

void MainWindow::askForCurrentScale()
{
    const int motor = m_device.motor();
    auto *dialog = new CurrentScaleDialog(motor, m_device.fullScaleAmps(motor), this);
    connect(dialog, &CurrentScaleDialog::chosen, m_scales, &CurrentScales::set);
    dialog->open();
}

/// The numbers take the place of the picture; everything around it stays.
void MainWindow::showBigNumbers(bool shown) { m_pages->setCurrentIndex(shown ? 1 : 0); }

void MainWindow::exportCsv()
{
    auto *dialog =
        new ExportDialog(m_workbench.capture(), *m_scope, m_files, m_settings.exportFolder, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    // What was asked of this session's motors says nothing about a file's samples.
    dialog->setMotionLog([this] {
        return !m_workbench.signalPlan().showsFile() && m_workbench.motionLog().rowCount() > 0;
    });
    connect(dialog, &ExportDialog::wanted, this, &MainWindow::runExport);
    if (m_scope->running()) { // what is on the screen now is what is meant
        m_scope->setRunning(false);
        connect(dialog, &QDialog::finished, m_scope, [this] { m_scope->setRunning(true); });
    }
    dialog->open();
}

void MainWindow::exported(const QString &path, const QString &motionLog)
{
    const QFileInfo file(path);
    m_settings.exportFolder = file.path();
    QString sentence = tr("Exported to %1.").arg(deviceText(file.filePath()));
    Banner::Kind kind = Banner::Kind::Note;
    if (!motionLog.isEmpty()) {
        const QString wrong = session::writeWholeFile(motionLog, m_workbench.motionLog().text());
        const QString name = deviceText(QFileInfo(motionLog).fileName());
        if (!wrong.isEmpty())
            kind = Banner::Kind::Warning;
        sentence += QLatin1Char(' ')
            + (wrong.isEmpty()
                    ? tr("The motion log is in %1.").arg(name)
                    : tr("The motion log %1 could not be written (%2).").arg(name, wrong));
    }
    say(kind, sentence);
    if (m_firstSteps->step() == FirstSteps::Step::Save)
        m_firstSteps->finish();
}

} // namespace widgets
