#include "widgets/scope/view.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/value_text.h"
#include "widgets/scope/colors.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/drawing/scope_canvas.h"
#include "widgets/scope/drawing/stale_mark.h"
#include "widgets/scope/drop.h"
#include "widgets/scope/events/lane.h"
#include "widgets/scope/ghosts.h"
#include "widgets/scope/hover.h"
#include "widgets/scope/mouse.h"
#include "widgets/scope/overlay.h"
#include "widgets/scope/overview.h"
#include "widgets/scope/plot_stack.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QEvent>
#include <QLabel>
#include <QVBoxLayout>
#include <QWindow>

#include <algorithm>

namespace widgets {

namespace {
constexpr int kFrameMs = 16;
constexpr int kCalmFrameMs = 66; ///< while nothing is driven

bool isSeen(const QWidget &window)
{
    const QWindow *screen = window.windowHandle();
    // One that is not put on a screen is drawn all the same: a picture of it is taken.
    return window.isVisible() && !window.isMinimized()
        && (!screen || !screen->isVisible() || screen->isExposed());
}
} // namespace

ScopeView::ScopeView(capture::Capture &capture, EventLog &events, QWidget *parent)
    : QWidget(parent)
    , m_capture(capture)
    , m_plot(new ScopeCanvas(this))
    , m_hint(wrappedLabel("scopeHint", this))
    , m_stale(new StaleMark(*this, this))
    , m_events(events)
    , m_lane(new EventLane(*this, m_events, this))
    , m_overview(new ScopeOverview(*this, capture, this))
    , m_stack(std::make_unique<PlotStack>(*m_plot, capture))
    , m_time(new TimeWindow(*m_stack, this))
    , m_overlay(new ScopeOverlay(*m_plot, *m_stack, capture, m_cursors, m_events))
    , m_drop(new ScopeDrop(*this, *m_plot, *m_stack))
    , m_mouse(new ScopeMouse(*this, *m_plot, *m_stack, *m_drop))
    , m_cursorActions(new CursorActions({m_cursors, m_events, *m_time, *m_stack, capture, *m_mouse,
                                            [this](double seconds) { showTime(seconds); }},
          this))
    , m_colors(new ScopeColors(*m_stack, *this, this))
    , m_ghosts(new ScopeGhosts(
          capture, *m_stack,
          [this] {
              const auto picture = visibleRange();
              return ScopeGhosts::Zero{m_marks.position.value_or(picture.from),
                  m_marks.position.has_value(), {picture.from, picture.to}};
          },
          this))
{
    setObjectName(QStringLiteral("scope"));
    m_plot->setObjectName(QStringLiteral("scopePlot"));
    setAccessibleName(tr("Scope"));
    setLocale(plainLocale(locale())); // as on the axes
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(200, 120);
    auto *layout = bare(new QVBoxLayout(this), 0);
    layout->addWidget(m_lane);
    layout->addWidget(m_plot, 1);
    layout->addWidget(m_overview);
    m_plot->setFocusProxy(this);
    m_hint->setText(tr("Drag a signal here, or select one in the tree and press Enter"));
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_frame.setSingleShot(true);
    m_frame.setTimerType(Qt::PreciseTimer);
    connect(&m_frame, &QTimer::timeout, this, [this] {
        if (seen())
            drawFrame();
        else
            m_owed = true; // hidden meanwhile
    });
    connect(m_plot, &ScopeCanvas::beforeReplot, this, [this] {
        m_stack->layOut();
        m_stack->renew();
    });
    connect(m_plot, &ScopeCanvas::afterReplot, this, &ScopeView::placeHint);
    connectParts();
    m_stack->applyPalette(palette());
    m_stack->setLeastLeft(m_lane->nameWidth());
    updateDescription();
    // The first resize event plots. What QCustomPlot queued when it was made, and the frame that the locale asked for,
    // would do so twice more, and paint the whole view again, right after the first picture.
    QCoreApplication::removePostedEvents(m_plot, QEvent::MetaCall);
    m_frame.stop();
    m_owed = false;
}

void ScopeView::connectParts()
{
    connect(m_mouse, &ScopeMouse::menuRequested, this, &ScopeView::showContextMenu);
    auto *hover = new ScopeHover(*this, *m_stack, m_capture, *m_plot);
    connect(m_mouse, &ScopeMouse::hovered, hover, &ScopeHover::showAt);
    connect(this, &ScopeView::drawn, hover, &ScopeHover::follow);
    connect(m_lane, &EventLane::markerWanted, m_cursorActions, &CursorActions::setMarkerAt);
    connect(m_lane, &EventLane::noteWanted, this, &ScopeView::noteWanted);
    connect(m_lane, &EventLane::timeWanted, this, &ScopeView::showTime);
    connect(m_drop, &ScopeDrop::registerDropped, this, &ScopeView::registerDropped);
    connect(m_drop, &ScopeDrop::traceDropped, this, &ScopeView::moveChannel);
    connect(m_time, &TimeWindow::originChanged, &m_events, &EventLog::setTimeOrigin);
    connect(m_time, &TimeWindow::redrawWanted, this, &ScopeView::redraw);
    connect(m_ghosts, &ScopeGhosts::redrawWanted, this, &ScopeView::redraw);
    connect(m_colors, &ScopeColors::changed, this, &ScopeView::redraw);
    connect(m_colors, &ScopeColors::changed, this, &ScopeView::channelsChanged);
}

ScopeView::~ScopeView()
{
    m_plot->removeEventFilter(m_mouse);
    delete m_plot; // before the stack whose plots its plottables refer to
}

void ScopeView::addChannel(capture::ChannelId channel, int plot, bool alone)
{
    const auto info = m_capture.info(channel);
    if (!info)
        return;
    m_stack->add(*info, plot, alone);
    updateDescription();
    redraw();
}

void ScopeView::removeChannel(capture::ChannelId channel)
{
    m_stack->remove(channel);
    updateDescription();
    redraw();
}

void ScopeView::moveChannel(capture::ChannelId channel, int plot)
{
    if (!m_stack->move(channel, plot))
        return;
    updateDescription();
    redraw();
    Q_EMIT channelMoved(channel);
}

QList<capture::ChannelId> ScopeView::channels() const
{
    const auto ids = m_stack->channels();
    return {ids.begin(), ids.end()};
}

int ScopeView::plotCount() const { return m_stack->count(); }

int ScopeView::plotOf(capture::ChannelId channel) const { return m_stack->plotOf(channel); }

QColor ScopeView::colorOf(capture::ChannelId channel) const { return m_stack->colorOf(channel); }

bool ScopeView::gridVisible() const { return m_stack->grid(); }

QRect ScopeView::plotRect(int plot) const
{
    if (plot < 0 || plot >= plotCount())
        return {};
    const QRect rect = m_stack->plot(plot).rect->rect();
    return {m_plot->mapTo(this, rect.topLeft()), rect.size()};
}

ValueRange ScopeView::valueRangeOf(capture::ChannelId channel) const
{
    const Trace *trace = m_stack->trace(channel);
    if (!trace)
        return {};
    return {trace->valueAxis->range().lower, trace->valueAxis->range().upper};
}

QMap<QString, ValueRange> ScopeView::heldRanges() const { return m_stack->heldRanges(); }

void ScopeView::setHeldRanges(const QMap<QString, ValueRange> &ranges)
{
    m_stack->setHeldRanges(ranges);
    redraw();
}

double ScopeView::readingStepOf(capture::ChannelId channel) const
{
    const Trace *trace = m_stack->trace(channel);
    return trace ? readingStep(*trace) : 0.0;
}

QString ScopeView::nameOf(capture::ChannelId channel) const
{
    const auto info = m_capture.info(channel);
    return info ? deviceText(info->name) : QString();
}

void ScopeView::setTriggerMarks(const TriggerMarks &marks)
{
    if (marks == m_marks)
        return;
    m_marks = marks;
    m_time->setAnchor(marks.position); // the picture is about what is around it
    m_overlay->setMarks(marks);
}

void ScopeView::setMeasureMarks(const MeasureMarks &marks) { m_overlay->setMeasure(marks); }

void ScopeView::captureChanged()
{
    if (m_capture.revision() != m_drawnRevision && m_stack->adoptChannels())
        updateDescription();
    if (m_running && m_capture.revision() != m_drawnRevision)
        drawWithin(m_calm ? kCalmFrameMs : kFrameMs);
}

void ScopeView::beat(bool waits)
{
    if (m_stack->beat(waits))
        redraw();
}

void ScopeView::redraw() { drawWithin(kFrameMs); }

/// The window that it is in is seen; or a tool that floats beside it and shows what follows the picture.
bool ScopeView::seen() const
{
    if (isSeen(*window()))
        return true;
    const auto docks = window()->findChildren<QDockWidget *>(QString(), Qt::FindDirectChildrenOnly);
    return std::any_of(docks.begin(), docks.end(),
        [](const QDockWidget *dock) { return dock->isFloating() && isSeen(*dock); });
}

void ScopeView::drawWithin(int frameMs)
{
    if (!seen()) {
        m_owed = true;
        return;
    }
    constexpr qint64 kMs = 1'000'000;
    const qint64 frame = frameMs * kMs;
    const qint64 since = m_lastFrame.isValid() ? m_lastFrame.nsecsElapsed() : frame;
    const qint64 left = std::clamp<qint64>(frame - since, 0, frame);
    // Rounded down: a frame that waited for the next whole millisecond each time would miss every few batches. There
    // are fewer calm frames than batches: none is missed there, and they are never too many.
    const auto wait = static_cast<int>((frameMs == kFrameMs ? left : left + kMs - 1) / kMs);
    if (!m_frame.isActive() || m_frame.remainingTime() > wait)
        m_frame.start(wait);
}

void ScopeView::showOwed()
{
    if (m_owed && seen())
        redraw();
}

void ScopeView::catchUp()
{
    if (m_owed)
        drawFrame();
}

void ScopeView::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    for (QObject *one : {static_cast<QObject *>(m_top), static_cast<QObject *>(m_onScreen)})
        if (one)
            one->removeEventFilter(this);
    m_top = window();
    m_onScreen = window()->windowHandle();
    m_top->installEventFilter(this);
    if (m_onScreen)
        m_onScreen->installEventFilter(this);
    showOwed();
}

bool ScopeView::eventFilter(QObject *watched, QEvent *event)
{
    const bool mayBeSeen = event->type() == QEvent::Expose
        || event->type() == QEvent::WindowStateChange || event->type() == QEvent::Show;
    if (mayBeSeen && (watched == m_top || watched == m_onScreen))
        showOwed();
    return QWidget::eventFilter(watched, event);
}

void ScopeView::drawFrame()
{
    m_frame.stop();
    m_owed = false;
    m_lastFrame.start();
    m_drawnRevision = m_capture.revision();
    if (m_running && m_time->following())
        m_time->follow();
    m_stack->growAxes();
    m_ghosts->place();
    ++m_redraws;
    m_plot->refresh();
    m_overlay->follow();
    Q_EMIT drawn();
}

QSize ScopeView::shapesSize() const
{
    return {m_plot->width(), m_lane->height() + m_plot->height()};
}

void ScopeView::drawShapes(QPaintDevice &device)
{
    catchUp();
    QCPPainter painter(&device);
    painter.setMode(QCPPainter::pmVectorized);
    m_lane->paintOn(painter);
    painter.translate(0, m_lane->height());
    m_plot->toPainter(&painter, m_plot->width(), m_plot->height());
    m_overlay->paintOn(painter);
}

void ScopeView::setRunning(bool running)
{
    if (m_running == running)
        return;
    m_running = running;
    Q_EMIT runningChanged(running);
    redraw();
}

/// What the shown channels cover; everything recorded if none is shown.
std::optional<capture::TimeSpan> ScopeView::shownSpan() const
{
    std::optional<capture::TimeSpan> all;
    for (const capture::ChannelId channel : m_stack->channels()) {
        if (const auto one = m_capture.timeSpan(channel)) {
            all = all
                ? capture::TimeSpan{std::min(all->from, one->from), std::max(all->to, one->to)}
                : *one;
        }
    }
    return m_stack->channels().empty() ? m_capture.timeSpan() : all;
}

void ScopeView::setVisibleRange(double from, double to) { m_time->set(from, to); }

void ScopeView::showTime(double seconds)
{
    if (!m_running || !m_time->following())
        m_time->show(seconds);
}

void ScopeView::fitAll()
{
    if (m_marks.position)
        setRunning(false); // the next record would take the picture away at once
    if (const auto span = shownSpan())
        setVisibleRange(span->from, std::max(span->to, span->from + TimeWindow::kLeastSpan));
    fitValues();
}

void ScopeView::fitValues()
{
    m_stack->fitValues();
    redraw();
}

void ScopeView::setGridVisible(bool visible)
{
    m_stack->setGrid(visible);
    redraw();
}

std::optional<capture::ChannelId> ScopeView::selectedChannel() const { return m_stack->selected(); }

bool ScopeView::overviewVisible() const { return m_overview->isVisibleTo(this); }

void ScopeView::setOverviewVisible(bool visible)
{
    m_overview->setVisible(visible);
    redraw();
}

void ScopeView::removeSelected()
{
    const auto channel = m_stack->selected();
    if (!channel)
        return;
    removeChannel(*channel);
    Q_EMIT removeRequested(*channel);
}

void ScopeView::updateDescription()
{
    QStringList names;
    for (const capture::ChannelId channel : m_stack->channels())
        names.append(QString::fromStdString(m_stack->trace(channel)->info.name));
    m_hint->setVisible(names.isEmpty());
    setAccessibleDescription(
        names.isEmpty() ? m_hint->text() : tr("Shows %1").arg(names.join(QStringLiteral(", "))));
    Q_EMIT channelsChanged();
}

void ScopeView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    // QCustomPlot keeps the colours and fonts it was made with.
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        m_stack->applyPalette(palette());
        m_stack->setLeastLeft(m_lane->nameWidth());
        updateDescription(); // others show the traces' colours
        redraw();
    } else if (event->type() == QEvent::LanguageChange) {
        m_hint->setText(tr("Drag a signal here, or select one in the tree and press Enter"));
        setAccessibleName(tr("Scope"));
        m_stack->setLeastLeft(m_lane->nameWidth());
        updateDescription();
    } else if (event->type() == QEvent::LocaleChange) {
        redraw();
    }
}

/// Inside the axes, whose numbers it must not cover.
void ScopeView::placeHint()
{
    constexpr int kAir = 24;
    const QRect inside = plotRect(0).adjusted(kAir, kAir, -kAir, -kAir);
    if (!m_hint->isHidden() && inside.isValid() && inside != m_hint->geometry())
        m_hint->setGeometry(inside);
    m_hint->raise();
}

void ScopeView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    placeHint();
    m_stale->setGeometry(rect());
}

int plotForUnit(const ScopeView &scope, const capture::Capture &capture, const QString &unit)
{
    const QList<capture::ChannelId> shown = scope.channels();
    for (const capture::ChannelId id : shown)
        if (const auto info = capture.info(id); info && deviceText(info->unit) == unit)
            return scope.plotOf(id);
    return shown.isEmpty() ? 0 : scope.plotCount();
}

} // namespace widgets
