// The scope's keys and its context menu: which wish each one is. What the wishes do is said elsewhere.
#include "widgets/scope/colors.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/ghosts.h"
#include "widgets/scope/plot_stack.h"
#include "widgets/scope/view.h"

#include <QKeyEvent>
#include <QMenu>

namespace widgets {

namespace {
constexpr double kKeyZoom = 1.5;
constexpr double kKeyPan = 0.1;
constexpr int kShiftedNudge = 10; ///< samples

/// A device's name is text, not a menu's shortcut mark.
QString menuText(QString name) { return name.replace(QLatin1Char('&'), QLatin1String("&&")); }
} // namespace

void ScopeView::keyPressEvent(QKeyEvent *event)
{
    const Qt::KeyboardModifiers held = event->modifiers() & ~Qt::KeypadModifier;
    const bool shift = held == Qt::ShiftModifier;
    if (held != Qt::NoModifier && !shift) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (event->key() == Qt::Key_M && event->isAutoRepeat())
        return; // a marker is meant once
    if (cursorKey(event->key(), shift) || scopeKey(event->key(), shift))
        return;
    QWidget::keyPressEvent(event);
}

/// Keys of the cursors and markers; the arrows only while one of them is active.
bool ScopeView::cursorKey(int key, bool shift)
{
    const int step = shift ? kShiftedNudge : 1;
    switch (key) {
    case Qt::Key_C:
        m_cursorActions->toggle();
        return true;
    case Qt::Key_M:
        m_cursorActions->setMarker();
        return true;
    case Qt::Key_1:
        m_cursorActions->accept(CursorEnd::A);
        return true;
    case Qt::Key_2:
        m_cursorActions->accept(CursorEnd::B);
        return true;
    case Qt::Key_Left:
        m_cursorActions->nudge(-step);
        return m_cursors.active().has_value();
    case Qt::Key_Right:
        m_cursorActions->nudge(step);
        return m_cursors.active().has_value();
    default:
        return false;
    }
}

bool ScopeView::scopeKey(int key, bool shift)
{
    switch (key) {
    case Qt::Key_Space:
        setRunning(!m_running);
        return true;
    case Qt::Key_F:
        shift ? fitValues() : fitAll();
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal: // the same key without Shift on many keyboards
    case Qt::Key_Up:
        m_time->zoom(kKeyZoom);
        return true;
    case Qt::Key_Minus:
    case Qt::Key_Down:
        m_time->zoom(1.0 / kKeyZoom);
        return true;
    case Qt::Key_Left:
        m_time->pan(-kKeyPan);
        return true;
    case Qt::Key_Right:
        m_time->pan(kKeyPan);
        return true;
    case Qt::Key_End:
        m_time->setFollowing(true);
        return true;
    case Qt::Key_G:
        setGridVisible(!gridVisible());
        return true;
    case Qt::Key_O:
        setOverviewVisible(!overviewVisible());
        return true;
    case Qt::Key_R:
        shift ? m_ghosts->drop(Reference::A) : m_ghosts->keep(Reference::A);
        return true;
    case Qt::Key_B:
        shift ? m_ghosts->drop(Reference::B) : m_ghosts->keep(Reference::B);
        return true;
    case Qt::Key_Delete:
        removeSelected();
        return true;
    case Qt::Key_Menu:
        showContextMenu(mapToGlobal(rect().center()), -1);
        return true;
    default:
        return false;
    }
}

void ScopeView::showContextMenu(const QPoint &globalPosition, int plot)
{
    auto *menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("scopeMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    fillContextMenu(*menu, plot);
    menu->popup(globalPosition);
}

void ScopeView::fillContextMenu(QMenu &menu, int plot)
{
    const auto toggle = [&menu](const QString &text, bool on, auto &&action) {
        QAction *entry = menu.addAction(text);
        entry->setCheckable(true);
        entry->setChecked(on);
        connect(entry, &QAction::toggled, std::forward<decltype(action)>(action));
    };
    toggle(tr("Run\tSpace"), m_running, [this](bool on) { setRunning(on); });
    toggle(tr("Follow the newest sample\tEnd"), m_time->following(),
        [this](bool on) { m_time->setFollowing(on); });
    toggle(tr("Grid\tG"), gridVisible(), [this](bool on) { setGridVisible(on); });
    toggle(tr("Whole recording below\tO"), overviewVisible(),
        [this](bool on) { setOverviewVisible(on); });
    toggle(tr("Cursors\tC"), m_cursors.visible(), [this] { m_cursorActions->toggle(); });
    menu.addSeparator();
    menu.addAction(tr("Fit everything\tF"), this, &ScopeView::fitAll);
    menu.addAction(tr("Fit values\tShift+F"), this, &ScopeView::fitValues);
    if (plot >= 0 && m_stack->plot(plot).axes.size() > 1)
        toggle(tr("Zeros of the axes at one height"), m_stack->plot(plot).zerosAligned,
            [this, plot](bool on) {
                m_stack->setZerosAligned(plot, on);
                redraw();
            });
    menu.addSeparator();
    for (const capture::ChannelId channel : channels())
        if (plot < 0 || plotOf(channel) == plot)
            fillTraceMenu(*menu.addMenu(menuText(nameOf(channel))), channel);
}

void ScopeView::fillTraceMenu(QMenu &menu, capture::ChannelId channel)
{
    Q_EMIT traceMenuOpening(menu, channel);
    m_colors->fill(*menu.addMenu(tr("&Colour")), channel);
    menu.addAction(tr("&Remove"), this, [this, channel] {
        removeChannel(channel);
        Q_EMIT removeRequested(channel);
    });
}

} // namespace widgets
