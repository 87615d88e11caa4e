#include "widgets/control/stop_filter.h"

#include <QCoreApplication>
#include <QKeyEvent>

namespace widgets {

StopFilter::StopFilter(QObject *parent)
    : QObject(parent)
{
    QCoreApplication::instance()->installEventFilter(this);
}

bool StopFilter::eventFilter(QObject *watched, QEvent *event)
{
    const QEvent::Type type = event->type();
    if (type != QEvent::ShortcutOverride && type != QEvent::KeyPress && type != QEvent::KeyRelease)
        return QObject::eventFilter(watched, event);
    const auto *key = static_cast<QKeyEvent *>(event);
    if (key->key() != Qt::Key_Escape || key->isAutoRepeat())
        return false;
    if (type == QEvent::KeyRelease) {
        m_act.reset();
    } else if (m_act != key->timestamp()) {
        m_act = key->timestamp();
        Q_EMIT stopPressed();
    }
    return false;
}

} // namespace widgets
