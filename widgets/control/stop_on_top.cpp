#include "widgets/control/stop_on_top.h"

#include "widgets/control/motor_button.h"

#include <QApplication>
#include <QEvent>
#include <QWindow>

#include <algorithm>
#include <utility>

namespace widgets {
namespace {

/// It is one of those that are laid over others.
bool isCover(const QObject *object)
{
    const auto *button = qobject_cast<const StopButton *>(object);
    return button != nullptr && button->isWindow();
}

bool belongsTo(const QWidget *window, const QWidget *other)
{
    while (window != nullptr && window != other)
        window = window->parentWidget();
    return window != nullptr;
}

} // namespace

void StopOnTop::Late::operator()(StopButton *button) const
{
    button->hide();
    button->deleteLater();
}

StopOnTop::StopOnTop(QWidget &window)
    : QObject(&window)
    , m_window(window)
{
    if (QGuiApplication::platformName().startsWith(QLatin1String("wayland")))
        return;
    window.installEventFilter(this);
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &StopOnTop::lay);
}

StopOnTop::~StopOnTop() = default;

bool StopOnTop::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::WindowBlocked:
        if (watched == &m_window) {
            qApp->installEventFilter(this);
            m_soon.start();
        }
        break;
    case QEvent::WindowUnblocked:
        if (watched == &m_window) {
            qApp->removeEventFilter(this);
            m_soon.stop();
            m_covers.clear();
        }
        break;
    case QEvent::Hide:
        if (watched == m_dialog)
            m_covers.clear();
        [[fallthrough]]; // another dialog may be left
    case QEvent::Show:
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::EnabledChange:
    case QEvent::WindowStateChange:
        // Not for its own, or it would argue with a window manager that wants them elsewhere.
        if (watched->isWidgetType() && !isCover(watched))
            m_soon.start();
        break;
    case QEvent::WindowActivate: // not every platform heeds what its flags say
        if (isCover(watched) && m_dialog != nullptr)
            m_dialog->activateWindow();
        break;
    default:
        break;
    }
    return false;
}

void StopOnTop::lay()
{
    std::vector<Cover> before = std::exchange(m_covers, {});
    QWidget *dialog = QApplication::activeModalWidget();
    if (std::exchange(m_dialog, dialog) != dialog)
        before.clear(); // the new one blocks what belongs to the one before
    if (dialog == nullptr)
        return;
    for (StopButton *over : m_window.findChildren<StopButton *>()) {
        const QRegion seen = seenOf(*over);
        if (seen.isEmpty())
            continue;
        const auto known = std::find_if(before.begin(), before.end(),
            [over](const Cover &cover) { return cover.over == over; });
        m_covers.push_back(known != before.end() ? std::move(*known) : coverOf(*over));
        StopButton &button = *m_covers.back().button;
        button.setGeometry(QRect(over->mapToGlobal(QPoint()), over->size()));
        if (seen == QRegion(button.rect()))
            button.clearMask();
        else
            button.setMask(seen);
        button.show();
    }
}

/// No child of the dialog as a widget: a dialog may do something to all of those.
StopOnTop::Cover StopOnTop::coverOf(StopButton &over) const
{
    Cover cover{&over, std::unique_ptr<StopButton, Late>(new StopButton)};
    StopButton &button = *cover.button;
    button.setObjectName(over.objectName() + QStringLiteral("OnTop"));
    button.setWindowFlags(Qt::Tool | Qt::FramelessWindowHint | Qt::WindowDoesNotAcceptFocus);
    button.setAttribute(Qt::WA_ShowWithoutActivating);
    button.setFocusPolicy(Qt::NoFocus);
    button.setText(over.text());
    connect(&button, &StopButton::stopPressed, &over, &StopButton::stopPressed);
    button.winId(); // makes the window
    button.windowHandle()->setTransientParent(m_dialog->windowHandle());
    return cover;
}

/// Empty where it is none to be pressed. Windows that belong to its own lie over it.
QRegion StopOnTop::seenOf(const StopButton &button) const
{
    const QWidget *window = button.window();
    if (!button.isEnabled() || window->isMinimized() || belongsTo(window, m_dialog))
        return {};
    QRegion seen = button.visibleRegion();
    const QPoint at = button.mapToGlobal(QPoint());
    for (const QWidget *other : QApplication::topLevelWidgets())
        if (other->isVisible() && other != window
            && (other == m_dialog || belongsTo(other, window)))
            seen -= other->frameGeometry().translated(-at);
    return seen;
}

} // namespace widgets
