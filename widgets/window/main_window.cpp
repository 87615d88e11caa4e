#include "widgets/window/main_window.h"

#include "lab/lent.h"
#include "widgets/base/banner.h"
#include "widgets/base/device.h"
#include "widgets/base/device_text.h"
#include "widgets/base/look/line_icon.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/messages.h"
#include "widgets/control/big_numbers.h"
#include "widgets/control/current_scale_dialog.h"
#include "widgets/control/current_scales.h"
#include "widgets/control/fault_help.h"
#include "widgets/control/limits_dialog.h"
#include "widgets/control/motion_question.h"
#include "widgets/control/motor_button.h"
#include "widgets/control/panel.h"
#include "widgets/control/stop_alarm.h"
#include "widgets/control/stop_on_top.h"
#include "widgets/files/lay_reference.h"
#include "widgets/files/marker_file.h"
#include "widgets/files/open_recording.h"
#include "widgets/files/recording_control.h"
#include "widgets/files/sample_room.h"
#include "widgets/files/sample_room_dialog.h"
#include "widgets/lab/give_back.h"
#include "widgets/lab/text.h"
#include "widgets/registers/panel.h"
#include "widgets/scope/colors.h"
#include "widgets/scope/drawing/stale_mark.h"
#include "widgets/scope/ghosts.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/trigger/control.h"
#include "widgets/scope/view.h"
#include "widgets/window/application.h"
#include "widgets/window/connect_bar.h"
#include "widgets/window/exporting.h"
#include "widgets/window/first_steps.h"
#include "widgets/window/leaving.h"
#include "widgets/window/link_news.h"
#include "widgets/window/opening.h"
#include "widgets/window/recent_files.h"
#include "widgets/window/replacing.h"
#include "widgets/window/scope_page.h"
#include "widgets/window/searching.h"
#include "widgets/window/shortcut_guard.h"
#include "widgets/window/status_strip.h"
#include "widgets/window/tools.h"
#include "widgets/window/workspaces.h"

#include <QAction>
#include <QChildEvent>
#include <QCloseEvent>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QStackedWidget>
#include <QTabBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <utility>

namespace widgets {
namespace {

constexpr int kRegisterWidth = 304;
constexpr int kRegisterMinimum = 240;
constexpr int kControlWidth = 268;
constexpr std::chrono::milliseconds kSettled(100); ///< after the first picture, before the tools

/// The way of the Tab key, where parts are made in another order than they are read in. Puts what lies in `parts`
/// first, part by part; everything keeps its place within its part, all others come after them.
void orderTabs(QWidget &window, const QList<QWidget *> &parts)
{
    QList<QWidget *> stops;
    for (QWidget *next = window.nextInFocusChain(); next != &window;
         next = next->nextInFocusChain()) {
        // What only hands the focus on is moved with what it hands it to.
        if (next->focusPolicy() != Qt::NoFocus && !next->focusProxy() && next->window() == &window)
            stops.append(next);
    }
    const auto partOf = [&parts](const QWidget *stop) {
        const auto part = std::find_if(parts.begin(), parts.end(),
            [stop](const QWidget *each) { return each == stop || each->isAncestorOf(stop); });
        return part - parts.begin();
    };
    std::stable_sort(stops.begin(), stops.end(),
        [&partOf](const QWidget *a, const QWidget *b) { return partOf(a) < partOf(b); });
    for (qsizetype i = 1; i < stops.size(); ++i)
        QWidget::setTabOrder(stops[i - 1], stops[i]);
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
    , m_trigger(new TriggerControl(workbench.trigger(), *m_scope, workbench.capture(), this))
    , m_connectBar(new ConnectBar(m_device, ports, this))
    , m_alarm(new StopAlarm(this))
    , m_leaving(new Leaving(
          m_device, [&workbench] { return workbench.sessionTime(); }, m_questions, this))
{
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(QStringLiteral("Rotorscope"));
    new ShortcutGuard(this);
    new StopOnTop(*this);
    m_workbench.registers().setPinned(settings.pinned);
    m_device.setUserLimits({settings.maxSpeedRpm, settings.maxCurrentAmps});
    m_connectBar->setTyped(settings.typedPorts);
    m_connectBar->setEndpoint(settings.port, settings.baud);
    m_connectBar->setProtocol(settings.protocol);

    makeFlows();
    makeFileActions();
    setCentralWidget(makeCentre());
    makeDocks();
    makeTools();
    makeWorkspaces();
    setStatusBar(m_status = new StatusStrip(m_device, this));
    setMenuWidget(makeTop());
    connectParts();
    orderTabs(*this, {menuWidget(), m_registerDock, m_control});

    resize(1280, 720);
    if (!settings.geometry.isEmpty())
        restoreGeometry(settings.geometry);
    m_workspaces->apply(settings.workspace);
    m_tools->docks().makeOpen();
    if (!settings.firstStepsDone)
        m_firstSteps->restart();
}

MainWindow::~MainWindow() = default;

void MainWindow::showWithin(const QSize &screen)
{
    constexpr QSize kFrame(16, 48);
    const QSize room = screen - kFrame;
    m_tools->docks().setRoom(room);
    if (width() > room.width() || height() > room.height())
        setWindowState(Qt::WindowMaximized);
    show();
}

Settings MainWindow::settings() const
{
    Settings now = m_settings;
    now.geometry = saveGeometry();
    now.port = m_connectBar->path();
    if (m_connectBar->baud() > 0)
        now.baud = m_connectBar->baud();
    now.typedPorts = m_connectBar->typed();
    now.protocol = m_connectBar->protocol();
    now.maxSpeedRpm = m_device.userLimits().maxSpeedRpm;
    now.maxCurrentAmps = m_device.userLimits().maxCurrentAmps;
    now.pinned = m_workbench.registers().pinned();
    now.registerColumns = m_registerPanel->columns();
    now.samplesOnDiskGB = m_room->wanted();
    now.recordFolder = m_record->folder();
    now.exportFolder = m_exporting->folder();
    now.workspace = m_workspaces->now();
    now.recentFiles = m_recent->paths();
    m_tools->keep(now);
    return now;
}

void MainWindow::makeFlows()
{
    m_record =
        new RecordingControl({m_workbench.recording(), m_device, m_workbench.events(), m_files,
                                 [this] { return m_workbench.eventRecorder().now(); }},
            m_settings.recordFolder, this);
    m_markers = new MarkerFile(m_workbench.events(), m_files, *m_record, this);
    connect(&m_workbench, &Workbench::noteReplayed, m_markers, &MarkerFile::replayed);
    m_replacing = new Replacing({m_workbench, *m_markers, *m_record, m_questions}, this);
    m_exporting = new Exporting({m_workbench, *m_scope, m_files, *m_replacing, m_questions, this},
        m_settings.exportFolder, this);
    m_searching = new Searching(*m_trigger, *m_scope, m_workbench.capture(), this);
    m_opening = new Opening(
        {m_workbench, *m_selection, *m_markers, *m_leaving, *m_replacing, m_files,
            [this] { return m_connectBar->connecting(); }, [this] { return m_record->folder(); },
            [this] { return m_exporting->folder(); }, m_questions, this,
            [this](OpenedRecording &opened, bool &good) {
                return layReference(*m_scope, m_workbench.capture(), opened, good);
            }},
        this);
    connect(m_opening, &Opening::outlineShown, m_exporting, &Exporting::setOutline);
    m_connectBar->setBeforeOpening(
        [this](std::function<void()> goOn) { m_opening->beforeConnecting(std::move(goOn)); });
    m_room = new SampleRoom(m_workbench.capture(), *m_workbench.archive(), this);
    m_room->setWanted(m_settings.samplesOnDiskGB);
    m_scales = new CurrentScales(m_device, m_settings.currentScales, this);
}

void MainWindow::makeFileActions()
{
    const auto make = [this](const QString &text, const char *name, const QKeySequence &keys,
                          auto *flow, auto slot) {
        auto *action = named(new QAction(text, this), name);
        action->setShortcut(keys);
        QMainWindow::addAction(action);
        connect(action, &QAction::triggered, flow, slot);
        return action;
    };
    m_openActions = {make(tr("&Open a recording\u2026"), "openRecording", Qt::CTRL | Qt::Key_O,
                         m_opening, &Opening::askForRecording),
        make(tr("Open as a re&ference\u2026"), "openReference", {}, m_opening,
            &Opening::askForReference),
        make(tr("Re&play a recording\u2026"), "replayRecording", Qt::CTRL | Qt::SHIFT | Qt::Key_R,
            m_opening, &Opening::askForReplay),
        make(tr("&Import CSV\u2026"), "importCsv", Qt::CTRL | Qt::SHIFT | Qt::Key_O, m_opening,
            &Opening::askForCsv)};
    QAction *save = make(tr("&Export\u2026"), "export", Qt::CTRL | Qt::SHIFT | Qt::Key_E,
        m_exporting, &Exporting::ask);
    save->setIconText(tr("Export\u2026"));
    save->setToolTip(tr("Writes samples or a picture to a file (Ctrl+Shift+E)"));
    m_exportActions = {save,
        make(tr("&Copy the picture"), "copyPicture", Qt::CTRL | Qt::SHIFT | Qt::Key_C, m_exporting,
            &Exporting::copyPicture)};
    const char *icons[] = {"open", "replay", "import"};
    for (int i = 0; i < 3; ++i)
        setLineIcon(*m_openActions[i], icons[i]);
    setLineIcon(*m_exportActions.back(), "picture");
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

    auto *stripLayout = edged(new QHBoxLayout(strip), kToolEdges, kGrid);
    stripLayout->addWidget(m_connectBar, 1);
    stripLayout->addWidget(stop);

    m_frame = new QWidget(top);
    m_frame->setFixedHeight(3);
    m_frame->setAutoFillBackground(true);
    // Over the plots: what one is about to click stays where it is. Below the legend of the first one.
    auto *plots = m_scope->findChild<QWidget *>(QStringLiteral("scopePlot"));
    auto *banner = new Banner(
        plots,
        [this, plots] { return plots->mapFrom(m_scope, m_scope->plotRect(0).topLeft()).y(); },
        this);
    connect(m_scope, &ScopeView::drawn, banner, &Banner::follow);
    m_news = new LinkNews(
        m_device, [this] { return m_connectBar->connecting(); },
        [this] { return m_leaving->wereAtRest(); }, *banner, this);

    auto *layout = bare(new QVBoxLayout(top), 0);
    layout->addWidget(bar);
    layout->addWidget(strip);
    layout->addWidget(m_frame);
    makeMenus(*bar);
    updateFrame();
    return top;
}

QWidget *MainWindow::makeCentre()
{
    auto *centre = new QWidget(this);
    m_firstSteps = new FirstSteps(m_device, centre);
    m_page = new ScopePage({m_workbench, *m_scope, *m_selection, *m_trigger, *m_record,
                               m_exportActions.front(), *this},
        centre);
    m_bigNumbers = new BigNumbers(m_device, m_workbench.registers(), centre);
    m_pages = new QStackedWidget(centre);
    m_pages->addWidget(m_page);
    m_pages->addWidget(m_bigNumbers);
    auto *pages = bare(new QVBoxLayout(centre), 0);
    pages->addWidget(m_firstSteps);
    pages->addWidget(m_pages, 1);
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

void MainWindow::makeTools()
{
    // The control panel keeps its height: state and commands stay in view while something is tuned.
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    m_tools = std::make_unique<Tools>(
        Tools::Parts{m_workbench, *m_scope, *m_trigger, m_page->strip(), *m_selection,
            m_registerPanel->actions(), *m_opening, m_files, *this},
        m_settings);
    connect(&m_tools->docks(), &ToolDocks::opened, m_firstSteps, &FirstSteps::setCrowded);
    // A form is to see a board come: it does not ask what came before it.
    connect(&m_device, &Device::openWished, this, &MainWindow::finishTools);
}

void MainWindow::makeWorkspaces()
{
    m_workspaces = new Workspaces(
        {m_workbench, *m_scope, *m_trigger, *m_tools, m_files, m_questions, *this}, this);
    auto *menu = named(new QMenu(tr("Open recen&t"), this), "recentFiles");
    menu->setIcon(lineIcon("recent"));
    m_recent = new RecentFiles(m_settings.recentFiles, *menu, this);
    m_recentMenu = menu;
    connect(m_opening, &Opening::used, m_recent, &RecentFiles::add);
    connect(m_workspaces, &Workspaces::used, m_recent, &RecentFiles::add);
    connect(m_recent, &RecentFiles::chosen, this, &MainWindow::openFile);
}

void MainWindow::openFile(const QString &path)
{
    if (path.endsWith(QLatin1String(".workspace"), Qt::CaseInsensitive))
        m_workspaces->open(path);
    else
        m_opening->openPath(path);
}

void MainWindow::finishTools() { m_tools->docks().makeAll(); }

void MainWindow::connectParts()
{
    connectFlows();
    m_alarm->setPlace(m_scope, m_control);
    connectAlarm();
    connectWatchList();
    showMotionQuestions(m_workbench.motion(), m_device, this);
    connect(m_control, &ControlPanel::causesWanted, this, &MainWindow::explainFaults);
    connect(m_control, &ControlPanel::limitsWanted, this, &MainWindow::askForLimits);
    connect(m_control, &ControlPanel::currentScaleWanted, this, &MainWindow::askForCurrentScale);
    connect(m_registerPanel, &RegisterPanel::registersChosen, m_selection,
        [this](const QList<quint32> &ids) {
            for (const quint32 id : ids)
                m_selection->add(id);
        });
    connect(m_firstSteps, &FirstSteps::simulatorWanted, m_connectBar, &ConnectBar::openSimulator);
    connect(m_firstSteps, &FirstSteps::boardWanted, m_connectBar, &ConnectBar::focusPort);
    connect(m_firstSteps, &FirstSteps::exportWanted, m_exporting, &Exporting::ask);
    connect(
        m_firstSteps, &FirstSteps::finished, this, [this] { m_settings.firstStepsDone = true; });

    connect(&m_workbench, &Workbench::heartbeat, m_control, &ControlPanel::refresh);
    connect(&m_workbench, &Workbench::heartbeat, m_status, &StatusStrip::refresh);
    connect(&m_workbench, &Workbench::heartbeat, m_room, &SampleRoom::refresh);
    connect(&m_workbench, &Workbench::heartbeat, this, &MainWindow::tellReleased);
    connect(m_room, &SampleRoom::refreshed, m_status, &StatusStrip::showHeld);
    connect(&m_workbench, &Workbench::advanced, m_scope, &ScopeView::captureChanged);
    connect(&m_device, &Device::linkStateChanged, this, [this] {
        m_news->linkChanged();
        linkChanged();
    });
    connect(&m_device, &Device::portStateChanged, this, [this] {
        m_news->portChanged();
        linkChanged();
    });
    connect(&m_device, &Device::armedStateChanged, this, &MainWindow::updateFrame);
    connect(&m_device, &Device::armedStateChanged, m_news, &LinkNews::armedChanged);
    connect(&m_device, &Device::identityChanged, m_news, &LinkNews::follow);
    connect(&m_workbench.signalPlan(), &SignalPlan::changed, this, &MainWindow::updateFrame);
    connect(&m_workbench.signalPlan(), &SignalPlan::forgot, m_control, [this] {
        if (m_workbench.signalPlan().showsFile())
            m_control->fileShown();
    });
}

void MainWindow::connectFlows()
{
    const auto tell = &LinkNews::warn;
    connect(m_connectBar, &ConnectBar::refused, m_news, tell);
    connect(&m_workbench.motion(), &MotionGate::failed, m_news, tell);
    auto *giveBack = new GiveBack(m_device, m_workbench.edits(), m_workbench.experiments(), this);
    connect(giveBack, &GiveBack::told, m_news, &LinkNews::givenBack);
    connect(&m_workbench.lentNote(), &session::LentNote::left, m_news,
        [this, giveBack](const QString &texts, const std::vector<drive::RegisterWrite> &back) {
            giveBack->offer(back);
            m_news->setLeft(
                texts.isEmpty() ? QString() : labSentence(lab::cutOffText(texts.toStdString())),
                back.empty() ? nullptr : giveBack);
        });
    connect(m_scales, &CurrentScales::told, m_news, tell);
    connect(&m_workbench.signalPlan(), &SignalPlan::failed, m_news, tell);
    connect(&m_workbench.signalPlan(), &SignalPlan::noticed, m_news, tell);
    connect(m_selection, &SignalSelection::noticed, m_news, tell);
    connect(m_leaving, &Leaving::said, m_news, tell);
    m_leaving->watch(m_workbench.experiments());
    connect(&m_device, &Device::interrupted, m_news,
        [this](const session::Interruption &what) { warn(interruptionText(what)); });
    connect(m_trigger, &TriggerControl::leftForRoll, m_news, [this](scope::Mode mode) {
        m_news->say(Banner::Kind::Note,
            tr("The trigger's mode was %1 and is Roll now: the newest samples are followed.")
                .arg(modeText(mode)));
    });
    connect(&m_scope->ghosts(), &ScopeGhosts::laid, m_news,
        [this](Reference which) { m_news->say(Banner::Kind::Note, laidText(*m_scope, which)); });
    connect(&m_scope->ghosts(), &ScopeGhosts::replaced, m_news, [this](Reference which, bool back) {
        m_news->say(Banner::Kind::Note, replacedText(which, back));
    });
    connect(m_record, &RecordingControl::said, m_news, &LinkNews::say);
    connect(m_markers, &MarkerFile::said, m_news, &LinkNews::say);
    connect(m_room, &SampleRoom::said, m_news, &LinkNews::say);
    connect(m_exporting, &Exporting::said, m_news, &LinkNews::say);
    connect(m_searching, &Searching::said, m_news, &LinkNews::say);
    connect(m_opening, &Opening::said, m_news, &LinkNews::say);
    connect(m_tools.get(), &Tools::said, m_news, &LinkNews::say);
    connect(m_workspaces, &Workspaces::said, m_news, &LinkNews::say);
    connect(m_replacing, &Replacing::exportWanted, m_exporting, &Exporting::ask);
    connect(m_exporting, &Exporting::closeWanted, this, &QWidget::close);
    connect(m_exporting, &Exporting::exported, m_firstSteps, [this] {
        if (m_firstSteps->step() == FirstSteps::Step::Save)
            m_firstSteps->finish();
    });
    connect(m_opening, &Opening::replayWanted, m_connectBar, &ConnectBar::openReplay);
    connect(m_opening, &Opening::disconnectWanted, m_leaving,
        [this](const std::function<void()> &goOn) {
            m_leaving->beforeDisconnecting([this, goOn] {
                m_connectBar->disconnectNow();
                m_opening->whenDisconnected(goOn);
            });
        });
    connect(m_connectBar, &ConnectBar::disconnectWanted, m_leaving,
        [this] { m_leaving->beforeDisconnecting([this] { m_connectBar->disconnectNow(); }); });
}

void MainWindow::connectAlarm()
{
    connect(&m_device, &Device::stopAdvanced, this, &MainWindow::stopAdvanced);
    connect(&m_device, &Device::stopsWanted, this, [this](const QStringList &ports) {
        if (!m_leaving->underWay())
            m_alarm->showWanted(ports);
    });
    connect(&m_device, &Device::identityChanged, m_alarm, [this] {
        const auto &board = m_device.identified();
        m_alarm->setMotors(board ? board->identity.motors : 0);
    });
    connect(m_alarm, &StopAlarm::takenBack, &m_device, &Device::forgetStopWished);
    connect(&m_device, &Device::stopImpossible, this, [this] {
        if (m_news->tellsLoss() && m_leaving->mayTurn() && !m_alarm->isVisible()
            && !m_leaving->underWay())
            m_alarm->raiseNotSent();
    });
}

void MainWindow::connectWatchList()
{
    WatchList &watch = m_workbench.watchList();
    watch.addSource([this] { return m_control->watchedRegisters(); });
    watch.addSource([this] { return m_bigNumbers->watchedRegisters(); });
    watch.addSource([this] { return m_registerPanel->visibleRegisters(); });
    connect(m_bigNumbers, &BigNumbers::watchedRegistersChanged, &watch, &WatchList::changed);
    connect(m_control, &ControlPanel::watchedRegistersChanged, &watch, &WatchList::changed);
    connect(m_registerPanel, &RegisterPanel::visibleRegistersChanged, &watch, &WatchList::changed);
}

void MainWindow::warn(const QString &sentence) { m_news->warn(sentence); }

void MainWindow::linkChanged()
{
    updateFrame();
    // What is shown of a board that does not answer must not be taken for the present.
    const bool expected = m_device.portOpen() || m_news->tellsLoss();
    const bool stale = m_device.identified() && !m_device.answering() && expected;
    m_scope->staleMark().say(stale ? tr("Not live: %1", "state of the link, e.g. board silent")
                                         .arg(linkStateText(m_device.link().state))
                                   : QString());
    m_page->showSource(); // its lamp is lit while samples can come
}

/// Once: the room is bounded, and what was let go is only where it was recorded.
void MainWindow::tellReleased()
{
    const bool released = m_workbench.capture().released() > 0;
    if (released && !m_workbench.signalPlan().showsFile() && !m_toldReleased)
        warn(m_room->fullText());
    m_toldReleased = released;
}

void MainWindow::updateFrame()
{
    const bool real =
        m_device.portOpen() && m_device.endpoint().kind == session::Endpoint::Kind::Serial;
    QPalette colors = palette();
    colors.setColor(QPalette::Window,
        real && m_device.armed() ? QColor(0xc0, 0x1f, 0x1f) : palette().color(QPalette::Mid));
    m_frame->setPalette(colors);
    QString title = QStringLiteral("Rotorscope");
    if (m_device.portOpen())
        title = tr("%1 \u2013 Rotorscope", "what is connected")
                    .arg(real ? deviceText(m_device.endpoint().path)
                            : replaying(m_device)
                            ? tr("Replay of %1").arg(fileNameText(m_device.endpoint().path))
                            : tr("Simulated board"));
    else if (m_workbench.signalPlan().showsFile())
        title =
            tr("%1 \u2013 Rotorscope", "what is connected").arg(fileNameText(m_opening->shown()));
    setWindowTitle(title);
}

void MainWindow::stopAdvanced(const drive::StopProgress &progress)
{
    if (progress.word == drive::StopWord::NotConfirmed && !m_leaving->underWay())
        m_alarm->raiseAlarm(progress.motor);
    else
        m_alarm->accept(progress);
}

void MainWindow::explainFaults()
{
    auto *help = findChild<FaultHelp *>();
    if (help == nullptr)
        help = new FaultHelp(m_device, m_workbench.faultRecords(), this);
    help->present();
}

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

void MainWindow::askForRoom()
{
    auto *dialog = new SampleRoomDialog(*m_room, this);
    connect(dialog, &SampleRoomDialog::chosen, m_room, &SampleRoom::setWanted);
    dialog->open();
}

/// Motors first, then markers, then a file that is being written; each asks, and closes again when it is answered.
void MainWindow::closeEvent(QCloseEvent *event)
{
    event->ignore();
    if (m_leaving->takesTime()) {
        m_leaving->before({tr("Stopping the motors before Rotorscope ends\u2026"),
            tr("End Rotorscope all the same\u2026"), [this] { close(); }});
        return;
    }
    if (m_markers->changedSinceLeft()) {
        m_replacing->beforeMarkersGo([this] { close(); });
        return;
    }
    if (!m_exporting->mayClose())
        return;
    m_device.close();
    event->accept();
    Q_EMIT closed();
}

void MainWindow::changeEvent(QEvent *event)
{
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_frame)
        updateFrame();
}

void MainWindow::paintEvent(QPaintEvent *event)
{
    QMainWindow::paintEvent(event);
    if (std::exchange(m_painted, true))
        return;
    QTimer::singleShot(kSettled, this, [this] {
        m_connectBar->refreshPorts();
        Q_EMIT settled();
        m_tools->docks().makeInTurns();
    });
}

/// Qt makes the tabs of docks when it needs them, gives them no name, and cuts the words of many until they are all
/// alike: they scroll instead.
void MainWindow::childEvent(QChildEvent *event)
{
    QMainWindow::childEvent(event);
    auto *tabs = qobject_cast<QTabBar *>(event->child());
    if (event->type() != QEvent::ChildPolished || tabs == nullptr)
        return;
    tabs->setAccessibleName(tr("Tools"));
    tabs->setElideMode(Qt::ElideNone);
    tabs->setUsesScrollButtons(true);
}

} // namespace widgets
