#include "widgets/base/banner.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/spacing.h"

#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace widgets {
namespace {

struct Colors {
    QColor back, text;
};

Colors colorsOf(Banner::Kind kind, bool dark)
{
    switch (kind) {
    case Banner::Kind::Note:
        return dark ? Colors{QColor(0x1f, 0x3a, 0x52), QColor(0xdc, 0xec, 0xfa)}
                    : Colors{QColor(0xdd, 0xec, 0xf9), QColor(0x10, 0x33, 0x50)};
    case Banner::Kind::Warning:
        return dark ? Colors{QColor(0x54, 0x40, 0x10), QColor(0xff, 0xee, 0xc4)}
                    : Colors{QColor(0xff, 0xee, 0xc4), QColor(0x4a, 0x35, 0x00)};
    case Banner::Kind::Bad:
        break;
    }
    return {QColor(0xb7, 0x1c, 0x1c), QColor(Qt::white)};
}

} // namespace

Banner::Banner(QWidget *over, std::function<int()> free, QWidget *window)
    : QFrame(window)
    , m_over(over)
    , m_free(std::move(free))
    , m_mark(new QLabel(this))
    , m_text(wrappedLabel("bannerText", this))
    , m_close(new QToolButton(this))
{
    setObjectName(QStringLiteral("banner"));
    setAutoFillBackground(true);
    m_mark->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_text->setFocusPolicy(Qt::NoFocus);
    m_close->setText(QStringLiteral("\u00d7"));
    m_close->setAutoRaise(true);
    m_close->setAccessibleName(tr("Close this message"));
    connect(m_close, &QToolButton::clicked, this, &Banner::clear);

    auto *layout = edged(new QHBoxLayout(this), kToolEdges, kGrid);
    layout->addWidget(m_mark);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_close);
    hide();
}

void Banner::place()
{
    const int width = m_over->width();
    const int height = std::min(layout()->totalHeightForWidth(width), m_over->height());
    const int top = std::clamp(m_free(), 0, m_over->height() - height);
    setGeometry(QRect(m_over->mapTo(parentWidget(), QPoint(0, top)), QSize(width, height)));
    raise();
}

void Banner::follow()
{
    if (isVisible())
        place();
}

bool Banner::eventFilter(QObject *watched, QEvent *event)
{
    if ((event->type() == QEvent::Resize || event->type() == QEvent::Move) && isVisible()) {
        place();
        QTimer::singleShot(0, this, &Banner::follow); // when what is in it has its new size
    }
    return QFrame::eventFilter(watched, event);
}

void Banner::say(Kind kind, const QString &sentence, QWidget *act)
{
    if (sentence.isEmpty())
        return;
    m_kind = kind;
    if (m_act != nullptr && m_act != act)
        m_act->hide();
    m_act = act;
    if (act != nullptr) {
        auto *row = static_cast<QHBoxLayout *>(layout());
        if (row->indexOf(act) < 0)
            row->insertWidget(row->indexOf(m_close), act);
        act->show();
    }
    m_mark->setText(kind == Kind::Note ? QStringLiteral("\u2139") : QStringLiteral("\u26a0"));
    m_text->setText(sentence);
    setAccessibleName(sentence);
    m_text->setFocusPolicy(Qt::ClickFocus); // so that it can be copied
    recolor();
    // Whatever moves it along; where it stands in the window may have changed since.
    for (QWidget *widget = m_over; widget != parentWidget(); widget = widget->parentWidget())
        widget->installEventFilter(this);
    place();
    show();
}

void Banner::clear()
{
    m_text->clear();
    m_text->setFocusPolicy(Qt::NoFocus); // nothing there, and so no name
    hide();
}

QString Banner::text() const { return m_text->text(); }

void Banner::changeEvent(QEvent *event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_close)
        recolor();
}

void Banner::recolor()
{
    const bool dark = QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
    const Colors colors = colorsOf(m_kind, dark);
    QPalette mine = palette();
    mine.setColor(QPalette::Window, colors.back);
    mine.setColor(QPalette::WindowText, colors.text);
    mine.setColor(QPalette::Text, colors.text);
    mine.setColor(QPalette::ButtonText, colors.text);
    mine.setColor(QPalette::Button, colors.back);
    setPalette(mine);
}

} // namespace widgets
