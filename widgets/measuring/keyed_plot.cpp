#include "widgets/measuring/keyed_plot.h"

#include "widgets/base/plot_look.h"

#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <algorithm>
#include <array>

namespace widgets {
namespace {

bool isPlain(const QKeyEvent &key)
{
    return (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
}

} // namespace

KeyedPlot::KeyedPlot(const QString &name, const QString &title, QWidget *parent)
    : QWidget(parent)
    , m_plot(new QCustomPlot(this))
    , m_why(new QLabel(this))
{
    setUpPlot(*m_plot);
    setObjectName(name);
    setAccessibleName(title);
    setFocusPolicy(Qt::StrongFocus);
    setToolTip(tr("Wheel or + and \u2212: zoom. Drag or arrows: move. F: everything."));
    m_plot->setFocusPolicy(Qt::NoFocus);
    m_plot->installEventFilter(this);
    m_why->setObjectName(name + QStringLiteral("Why"));
    m_why->setTextFormat(Qt::PlainText);
    m_why->setAlignment(Qt::AlignCenter);
    m_why->setWordWrap(true);
    m_why->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
}

void KeyedPlot::say(const QString &why)
{
    if (why == m_why->text())
        return;
    m_why->setText(why);
    m_why->setVisible(!why.isEmpty());
    setAccessibleDescription(why);
}

void KeyedPlot::dress() { dressPlot(*m_plot, *this); }

void KeyedPlot::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    const auto type = event->type();
    const bool look = type == QEvent::PaletteChange || type == QEvent::FontChange;
    if (look)
        dress();
    if (look || type == QEvent::LocaleChange)
        draw();
}

void KeyedPlot::resizeEvent(QResizeEvent *event)
{
    constexpr int kMargin = 20;
    QWidget::resizeEvent(event);
    m_why->setGeometry(rect().adjusted(kMargin, 0, -kMargin, 0));
    draw();
}

bool KeyedPlot::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::MouseButtonPress)
        setFocus(Qt::MouseFocusReason);
    if (event->type() == QEvent::MouseButtonDblClick)
        fit();
    return QWidget::eventFilter(watched, event);
}

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
bool KeyedPlot::handleKey(int key)
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
    if (!isPlain(*event) || !handleKey(event->key()))
        QWidget::keyPressEvent(event);
}

} // namespace widgets
