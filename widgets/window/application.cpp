#include "widgets/window/application.h"

#include <QKeyEvent>
#include <QWidget>
#include <QWindow>

namespace widgets {

namespace {
/// Whether `window` is one of those behind the dialog.
bool blocks(const QWidget &dialog, const QWindow *window)
{
    const QWindow *behind = dialog.windowHandle();
    while (behind && behind != window)
        behind = behind->transientParent();
    return behind && behind != dialog.windowHandle();
}

/// Qt throws away the keys of a window that a dialog blocks, and some window managers let such a window have the focus.
void keepKeysFromBlockedWindows(const QWindow *focused)
{
    QWidget *dialog = QApplication::activeModalWidget();
    if (dialog && focused && blocks(*dialog, focused))
        dialog->activateWindow();
}
} // namespace

Application::Application(int &argc, char **argv)
    : QApplication(argc, argv)
{
    setAttribute(Qt::AA_DontUseNativeDialogs);
    setAttribute(Qt::AA_DontUseNativeMenuBar);
    connect(this, &QGuiApplication::focusWindowChanged, this, &keepKeysFromBlockedWindows);
}

bool Application::notify(QObject *receiver, QEvent *event)
{
    const QEvent::Type type = event->type();
    if (type == QEvent::ShortcutOverride || type == QEvent::KeyPress
        || type == QEvent::KeyRelease) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->key() == Qt::Key_Escape && !key->isAutoRepeat()) {
            if (type == QEvent::KeyRelease) {
                m_act.reset();
            } else if (m_act != key->timestamp()) {
                m_act = key->timestamp();
                Q_EMIT stopPressed();
            }
        }
    }
    return QApplication::notify(receiver, event);
}

} // namespace widgets
