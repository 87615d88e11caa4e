#include "widgets/measuring/keyed_plot.h"

#include <QKeyEvent>

#include <algorithm>
#include <array>

namespace widgets {
namespace {

bool isPlain(const QKeyEvent &key)
{
    return (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
}

} // namespace

bool KeyedPlot::event(QEvent *event)
{
    if (event->type() != QEvent::ShortcutOverride)
        return QWidget::event(event);
    const auto *key = static_cast<QKeyEvent *>(event);
    constexpr std::array kOwn{Qt::Key_Plus, Qt::Key_Equal, Qt::Key_Minus, Qt::Key_F};
    if (isPlain(*key) && std::find(kOwn.begin(), kOwn.end(), key->key()) != kOwn.end())
        event->accept();
    return true;
}

/// A key without a modifier, of the keypad or not. False leaves it to what is around the picture.
bool KeyedPlot::takeKey(int key)
{
    constexpr double kKeyPan = 0.1;
    switch (key) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: // the same key without Shift on many keyboards
        zoom(kKeyZoom);
        return true;
    case Qt::Key_Minus:
        zoom(1.0 / kKeyZoom);
        return true;
    case Qt::Key_Left:
        pan(-kKeyPan);
        return true;
    case Qt::Key_Right:
        pan(kKeyPan);
        return true;
    case Qt::Key_Up:
        panUp(kKeyPan);
        return true;
    case Qt::Key_Down:
        panUp(-kKeyPan);
        return true;
    case Qt::Key_F:
        fit();
        return true;
    default:
        return false;
    }
}

void KeyedPlot::keyPressEvent(QKeyEvent *event)
{
    if (!isPlain(*event) || !takeKey(event->key()))
        QWidget::keyPressEvent(event);
}

} // namespace widgets
