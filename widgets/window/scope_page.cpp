#include "widgets/window/scope_page.h"

#include "widgets/base/device.h"
#include "widgets/base/flow_layout.h"
#include "widgets/base/lamp.h"
#include "widgets/base/look/line_icon.h"
#include "widgets/base/look/spacing.h"
#include "widgets/files/recording_control.h"
#include "widgets/files/replay_bar.h"
#include "widgets/scope/cursor_panel.h"
#include "widgets/scope/signals/channel_strip.h"
#include "widgets/scope/signals/set_point_trace.h"
#include "widgets/scope/tools.h"
#include "widgets/scope/trigger/bar.h"
#include "widgets/scope/trigger/control.h"
#include "widgets/scope/view.h"
#include "widgets/window/workbench.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace widgets {
namespace {

/// Height of plots and what is around them, below which there is little room when cursors are read as well.
constexpr int kCrowdedHeight = 480;
constexpr int kButtonHeight = 26;
constexpr int kLeastWidth = 360; ///< of the picture; the registers beside it give way first

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
QString barStyle(const QPalette &palette)
{
    return QStringLiteral("QToolButton { padding: 3px 6px; border: 1px solid %1; border-radius: "
                          "4px; background: %2; }"
                          "QToolButton:hover { background: %3; }"
                          "QToolButton:checked { background: %4; border-color: %5; }"
                          "QToolButton:focus { border-color: %5; }")
        .arg(palette.color(QPalette::Mid).name(), palette.color(QPalette::Button).name(),
            palette.color(QPalette::Base).name(), palette.color(QPalette::Mid).name(),
            palette.color(QPalette::Highlight).name());
}

/// What is beside a button stays where it is when it is pressed.
void keepRoomFor(QToolButton &button, const QStringList &words)
{
    const QString now = button.text();
    int widest = 0;
    button.setMinimumWidth(0);
    for (const QString &word : words) {
        button.setText(word);
        widest = std::max(widest, button.sizeHint().width());
    }
    button.setText(now);
    button.setMinimumWidth(widest);
}

} // namespace

ScopePage::ScopePage(const Parts &parts, QWidget *parent)
    : QWidget(parent)
    , m_parts(parts)
{
    ScopeView &scope = parts.scope;
    Workbench &workbench = parts.workbench;
    m_tools = new ScopeTools(scope, parts.trigger, parts.window);
    makeActions();
    makeSetPoints();
    auto *layout = bare(new QVBoxLayout(this), 0);
    layout->addWidget(m_bar = makeBar());
    layout->addWidget(parts.record.line());
    layout->addWidget(new ReplayBar(workbench.device(), workbench.replay(), this));
    auto *trigger = new TriggerBar(parts.trigger, scope, workbench.device(), this);
    layout->addWidget(trigger);
    connect(&workbench, &Workbench::heartbeat, trigger, &TriggerBar::refreshAge);
    layout->addWidget(&scope, 1);
    showCursorsIn(*layout);
    const auto beat = [&scope, &workbench] {
        scope.beat(workbench.device().portOpen() && !workbench.signalPlan().showsFile());
    };
    connect(&workbench, &Workbench::heartbeat, &scope, beat);
    // What stood before the port was opened counts no more at once, not with the next beat.
    connect(&workbench.device(), &Device::portStateChanged, &scope, beat);
    m_strip = new ChannelStrip(parts.selection, workbench.device(), this);
    layout->addWidget(m_strip);
    connect(&workbench, &Workbench::heartbeat, m_strip, &ChannelStrip::measure);
    m_strip->foldWhen(
        [this, &scope] { return scope.cursors().visible() && height() < kCrowdedHeight; });
    connect(&scope.cursors(), &Cursors::changed, m_strip, &ChannelStrip::room);
    connect(&scope, &ScopeView::drawn, m_strip, &ChannelStrip::room);
    for (const auto changed : {&Device::identityChanged, &Device::linkStateChanged})
        connect(&workbench.device(), changed, this, &ScopePage::pace);
    connect(&workbench.device(), &Device::statusChanged, this, &ScopePage::pace);
    pace();
    scope.setMinimumSize(kLeastWidth, 160);
}

void ScopePage::makeActions()
{
    ScopeView &scope = m_parts.scope;
    m_run = m_tools->make(tr("Run", "the scope's picture moves"), Qt::Key_Space,
        tr("Lets the picture run or holds it; recording goes on (Space)"), &ScopeView::setRunning);
    m_run->setObjectName(QStringLiteral("scopeRun"));
    m_run->setCheckable(true);
    m_follow =
        m_tools->make(tr("Follow"), Qt::Key_End, tr("Keeps the newest samples in view (End)"),
            [&scope](bool on) { scope.time().setFollowing(on); });
    m_follow->setCheckable(true);
    m_follow->setChecked(scope.time().following());
    m_fit = m_tools->make(
        tr("Fit", "show all samples"), Qt::Key_F, tr("Shows everything (F)"), &ScopeView::fitAll);
    m_fitValues = m_tools->make(tr("Fit values"), Qt::SHIFT | Qt::Key_F,
        tr("Fits the value axes only (Shift+F)"), &ScopeView::fitValues);
    m_zoomIn = m_tools->make(tr("Zoom in"), Qt::Key_Plus, tr("Shows half the time (+)"),
        [&scope] { scope.time().zoom(2.0); });
    m_zoomOut = m_tools->make(tr("Zoom out"), Qt::Key_Minus, tr("Shows twice the time (\u2212)"),
        [&scope] { scope.time().zoom(0.5); });
    const std::pair<QAction *, const char *> icons[] = {{m_follow, "follow"}, {m_fit, "fit"},
        {m_fitValues, "fit-values"}, {m_zoomIn, "zoom-in"}, {m_zoomOut, "zoom-out"},
        {m_parts.save, "export"}};
    for (const auto &[action, icon] : icons)
        setLineIcon(*action, icon);
    connect(&scope, &ScopeView::runningChanged, this, &ScopePage::showSource);
    connect(&m_parts.selection, &SignalSelection::changed, this, &ScopePage::showSource);
    connect(&scope.time(), &TimeWindow::followingChanged, m_follow, &QAction::setChecked);
    showSource();
}

void ScopePage::makeSetPoints()
{
    Workbench &workbench = m_parts.workbench;
    auto *trace = new SetPointTrace(workbench.capture(), m_parts.scope, this);
    connect(&workbench.setPoints(), &session::SetPointTap::left, trace, &SetPointTrace::accept,
        Qt::QueuedConnection);
    connect(&workbench.setPoints(), &session::SetPointTap::ended, trace, &SetPointTrace::finish,
        Qt::QueuedConnection);
    connect(&workbench, &Workbench::advanced, trace,
        [trace, &workbench] { trace->advance(workbench.eventRecorder().now()); });
    connect(&workbench.device(), &Device::portStateChanged, trace, [trace, &workbench] {
        if (!workbench.device().portOpen())
            trace->end();
    });
    m_setPoints = new QAction(tr("Set-po&ints as sent"), this);
    m_setPoints->setObjectName(QStringLiteral("setPointsAsSent"));
    m_setPoints->setCheckable(true);
    m_setPoints->setToolTip(tr("Draws each set-point from the instant at which its bytes left. How "
                               "soon the board had it stands with the command among the events."));
    connect(m_setPoints, &QAction::triggered, trace, &SetPointTrace::setShown);
    connect(trace, &SetPointTrace::shownChanged, m_setPoints, &QAction::setChecked);
}

/// What nothing moves changes slowly enough.
void ScopePage::pace()
{
    const bool calm = m_parts.workbench.device().allIdle();
    if (std::exchange(m_calm, calm) != calm)
        m_parts.scope.setCalm(calm);
}

QString ScopePage::sourceText() const
{
    const Device &device = m_parts.workbench.device();
    if (device.answering())
        return replaying(device) ? tr("Replay", "the scope shows it")
                                 : tr("Run", "the scope's picture moves");
    return m_parts.workbench.signalPlan().showsFile() ? tr("File", "the scope shows it")
                                                      : tr("Run", "the scope's picture moves");
}

void ScopePage::showSource()
{
    const bool running = m_parts.scope.running();
    m_run->setChecked(running);
    const QString held = tr("Hold", "the scope's picture stands still");
    const QString source = sourceText();
    m_run->setText(running ? source : held);
    if (m_runButton)
        keepRoomFor(*m_runButton, {source, held});
    m_run->setIcon(runIcon(running, m_parts.workbench.device().answering(), palette()));
}

void ScopePage::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || !m_bar)
        return;
    showSource();
    m_bar->setStyleSheet(barStyle(palette()));
}

QWidget *ScopePage::makeBar()
{
    auto *bar = new QWidget(this);
    bar->setStyleSheet(barStyle(palette()));
    auto *layout = edged(new QHBoxLayout(bar), kToolEdges, kHalfGrid);
    auto *buttons = new QWidget(bar); // two lines where the words are long and the screen is small
    auto *flow = new FlowLayout(kHalfGrid, buttons);
    const auto put = [bar, flow](QAction *action, const QString &name) {
        auto *button = new QToolButton(bar);
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setFocusPolicy(Qt::TabFocus);
        button->setMinimumHeight(kButtonHeight);
        button->setAccessibleName(name);
        flow->addWidget(button);
        return button;
    };
    for (QAction *action :
        {m_run, m_follow, m_fit, m_fitValues, m_zoomIn, m_zoomOut, m_tools->cursors()}) {
        QToolButton *button = put(action, action->text());
        // The bar has little room, and less in other languages; menus and screen readers get the words.
        if (fitting().contains(action))
            button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        connect(action, &QAction::changed, button,
            [button, action] { button->setAccessibleName(action->text()); });
        if (action == m_run)
            m_runButton = button;
    }
    showSource();
    keepRoomFor(*put(m_parts.record.toggle(), tr("Record to disk")), RecordingControl::signs());
    put(m_parts.save, tr("Export"));
    flow->setTrailing(2);
    layout->addWidget(buttons, 1);
    return bar;
}

/// Made when cursors are first shown.
void ScopePage::showCursorsIn(QVBoxLayout &layout)
{
    connect(
        &m_parts.scope.cursors(), &Cursors::changed, this,
        [this, &layout, place = layout.count()] {
            auto *panel = new CursorPanel(m_parts.scope, m_parts.workbench.capture(), this);
            layout.insertWidget(place, panel);
            panel->tabAfterScope();
        },
        Qt::SingleShotConnection);
}

} // namespace widgets
