#include "widgets/window/tool_docks.h"

#include "widgets/base/look/line_icon.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/control/motor_button.h"
#include "widgets/window/workbench.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QHBoxLayout>
#include <QMainWindow>
#include <QScrollArea>
#include <QStyle>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace widgets {
namespace {

/// A share of the window's height, but no more than leaves the scope two plots that can be read, with the bars around
/// them.
int toolHeight(const QMainWindow &window, double share)
{
    constexpr int kForScope = 460; // pixels
    return std::min(int(window.height() * share), window.height() - kForScope);
}

/// Before it is shown: a tool is made narrow, where its buttons stand in many lines, and a window that has grown for
/// them does not shrink again.
void layOut(QWidget &widget, int width = 0)
{
    if (width > 0)
        widget.resize(width, widget.height());
    if (QLayout *layout = widget.layout()) {
        layout->invalidate();
        layout->activate();
    }
    for (QObject *child : widget.children())
        if (auto *part = qobject_cast<QWidget *>(child); part != nullptr && !part->isWindow())
            layOut(*part);
}

} // namespace

ToolDocks::ToolDocks(QMainWindow &window, Workbench &workbench)
    : m_window(window)
    , m_workbench(workbench)
    , m_close(named(new QAction(tr("&Close all tools"), this), "closeTools"))
{
    m_close->setEnabled(false);
    connect(m_close, &QAction::triggered, this, &ToolDocks::closeAll);
    connect(this, &ToolDocks::opened, m_close, &QAction::setEnabled);
}

QAction *ToolDocks::add(const QString &title, const char *name, const char *icon,
    const QKeySequence &keys, std::function<Form *()> makeForm)
{
    auto *dock = named(new QDockWidget(title, &m_window), name);
    m_window.addDockWidget(Qt::BottomDockWidgetArea, dock);
    if (!m_tools.empty())
        m_window.tabifyDockWidget(m_tools.front().dock, dock);
    m_tools.push_back({dock, std::move(makeForm)});
    dock->hide();

    auto *action = new QAction(lineIcon(icon), title, &m_window);
    action->setShortcut(keys);
    action->setObjectName(QLatin1String(name) + QStringLiteral("Open"));
    m_actions.append(action);
    const std::size_t index = m_tools.size() - 1;
    connect(action, &QAction::triggered, this, [this, index] { open(index); });
    connect(dock, &QDockWidget::visibilityChanged, &m_workbench.watchList(), &WatchList::changed);
    connect(dock, &QDockWidget::visibilityChanged, this, [this, index] {
        if (!m_tools[index].dock->isHidden())
            formOf(m_tools[index]);
        Q_EMIT opened(anyOpen());
    });
    return action;
}

void ToolDocks::open(std::size_t index)
{
    const bool first = !anyOpen();
    Tool &tool = m_tools[index];
    const Form *form = formOf(tool);
    if (!fits(*tool.dock))
        floatBelow(tool);
    if (!tool.dock->isFloating())
        layOut(*tool.dock, m_window.centralWidget()->width());
    tool.dock->show();
    tool.dock->raise();
    if (first)
        m_window.resizeDocks(
            {tool.dock}, {toolHeight(m_window, form->heightShare())}, Qt::Vertical);
    tool.form->focusFirst();
}

/// Into the window without making it higher than its screen.
bool ToolDocks::fits(const QDockWidget &dock) const
{
    const bool beside = std::any_of(m_tools.begin(), m_tools.end(),
        [](const Tool &tool) { return !tool.dock->isHidden() && !tool.dock->isFloating(); });
    return dock.isFloating() || beside
        || m_window.minimumSizeHint().height() + dock.minimumSizeHint().height() <= m_room.height();
}

/// At the window's lower edge, where it would stand in it: what is above it has the Stop. There is one such place: what
/// was put there and not moved since goes.
void ToolDocks::floatBelow(Tool &tool)
{
    if (m_below != nullptr && m_below != &tool && isWhereItWasPut())
        m_below->dock->close();
    m_below = &tool;
    tool.dock->setFloating(true);
    fitBelow();
}

bool ToolDocks::isWhereItWasPut() const
{
    return m_below->dock->isFloating() && m_below->dock->geometry() == m_belowAt;
}

/// The control panel stays in view where the tool is narrow enough.
void ToolDocks::fitBelow()
{
    QDockWidget &dock = *m_below->dock;
    const int bar = dock.style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    const QSize form = m_below->form->sizeHint().expandedTo(m_below->form->minimumSizeHint());
    const int beside = m_window.centralWidget()->geometry().right() + 1;
    const int width = form.width() + bar <= beside ? beside : m_window.width();
    const int height = std::min(heightAt(width, *m_below), m_window.height() * 2 / 3);
    dock.resize(QSize(width, height).expandedTo(dock.minimumSizeHint()));
    dock.move(m_window.geometry().bottomLeft() - QPoint(0, dock.height() - 1));
    m_belowAt = dock.geometry();
}

/// What is in it needs another height now: a board, another page. Once the user has moved it or drawn at its edges it
/// stays.
bool ToolDocks::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::LayoutRequest && m_below != nullptr
        && (watched == m_below->form || watched == m_below->dock->widget()) && isWhereItWasPut())
        fitBelow();
    return QObject::eventFilter(watched, event);
}

/// Of a dock that shows its form whole, with what is below and above the form.
int ToolDocks::heightAt(int width, const Tool &tool)
{
    const QWidget &content = *tool.dock->widget();
    const int title = tool.dock->minimumSizeHint().height() - content.minimumSizeHint().height();
    const QLayoutItem &below = *content.layout()->itemAt(1);
    const auto needed = [width](const auto &item) {
        return std::max(
            item.hasHeightForWidth() ? item.heightForWidth(width) : 0, item.sizeHint().height());
    };
    const int form = std::max(needed(*tool.form), tool.form->minimumSizeHint().height());
    return title + form + needed(below);
}

void ToolDocks::closeAll()
{
    for (const Tool &tool : m_tools)
        tool.dock->close();
}

Form *ToolDocks::formOf(Tool &tool)
{
    if (tool.form)
        return tool.form;
    auto *content = new QWidget(tool.dock);
    auto *scroll = new QScrollArea(content);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    Form *form = tool.form = tool.make();
    form->installEventFilter(this);
    content->installEventFilter(this);
    scroll->setWidget(form);
    auto *stop = new StopButton(content); // every window that can stay open has one
    stop->setObjectName(tool.dock->objectName() + QStringLiteral("Stop"));
    stop->setVisible(tool.dock->isFloating());
    connect(stop, &StopButton::stopPressed, &m_workbench.device(), &Device::stop);
    connect(tool.dock, &QDockWidget::topLevelChanged, stop, &QWidget::setVisible);
    auto *layout = bare(new QVBoxLayout(content), 0);
    layout->addWidget(scroll, 1);
    auto *below = new QHBoxLayout;
    below->setSpacing(kGrid); // nothing is close to Stop
    below->addWidget(stop);
    if (QWidget *footer = form->footer()) {
        below->setContentsMargins(kGrid, kFineGrid, kGrid, kHalfGrid);
        below->addWidget(footer, 1);
    } else {
        below->addStretch(1);
    }
    layout->addLayout(below);
    layOut(*content, std::max(m_window.centralWidget()->width(), tool.dock->width()));
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
    connect(form, &Form::failed, this, &ToolDocks::failed);
    return form;
}

void ToolDocks::makeOpen()
{
    for (Tool &tool : m_tools)
        if (!tool.dock->isHidden())
            formOf(tool);
}

void ToolDocks::makeAll()
{
    for (Tool &tool : m_tools)
        formOf(tool);
}

void ToolDocks::makeInTurns()
{
    const auto next = std::find_if(
        m_tools.begin(), m_tools.end(), [](const Tool &tool) { return tool.form == nullptr; });
    if (next == m_tools.end())
        return;
    formOf(*next);
    QTimer::singleShot(0, this, &ToolDocks::makeInTurns);
}

void ToolDocks::showOnly(const QStringList &names)
{
    constexpr double kShare = 0.36; // of the window's height: the traces are what is looked at
    constexpr int kSideBySide = 1600; // pixels of the window, for two of them and the control panel
    QList<QDockWidget *> shown;
    for (Tool &tool : m_tools)
        if (!names.contains(tool.dock->objectName()))
            tool.dock->hide();
    for (const QString &name : names)
        for (Tool &tool : m_tools) {
            if (tool.dock->objectName() != name)
                continue;
            formOf(tool);
            tool.dock->setFloating(false);
            // From its tabs, in which it could not be split off.
            m_window.removeDockWidget(tool.dock);
            m_window.addDockWidget(Qt::BottomDockWidgetArea, tool.dock, Qt::Horizontal);
            if (!shown.isEmpty() && m_window.width() < kSideBySide)
                m_window.tabifyDockWidget(shown.first(), tool.dock);
            tool.dock->show();
            shown.append(tool.dock);
        }
    if (!shown.isEmpty())
        shown.first()->raise();
    m_window.resizeDocks(
        shown, QList<int>(shown.size(), toolHeight(m_window, kShare)), Qt::Vertical);
}

bool ToolDocks::anyOpen() const
{
    return std::any_of(
        m_tools.begin(), m_tools.end(), [](const Tool &tool) { return !tool.dock->isHidden(); });
}

} // namespace widgets
