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

void KeyedPlot::keyPressEvent(QKeyEvent *event)
{
    if (!isPlain(*event) || !takeKey(event->key()))
        QWidget::keyPressEvent(event);
}

} // namespace widgets
