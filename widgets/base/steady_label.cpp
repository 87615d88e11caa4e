#include "widgets/base/steady_label.h"

#include <QHelpEvent>
#include <QPainter>
#include <QStyle>
#include <QToolTip>

#include <algorithm>

namespace widgets {

SteadyLabel::SteadyLabel(QWidget *parent, int lines)
    : QLabel(parent)
    , m_lines(lines)
{
    setTextFormat(Qt::PlainText);
}

void SteadyLabel::setRoomFor(const QStringList &texts)
{
    if (texts == m_room)
        return;
    m_room = texts;
    updateGeometry();
}

void SteadyLabel::setLines(int lines)
{
    m_lines = lines;
    updateGeometry();
    update();
}

QStringList SteadyLabel::lines() const
{
    QStringList all = text().split(QLatin1Char('\n'));
    const QString rest = all.mid(m_lines - 1).join(QLatin1Char(' '));
    all = all.mid(0, m_lines - 1);
    all.append(rest);
    return all;
}

QSize SteadyLabel::sizeHint() const
{
    ensurePolished();
    const QFontMetrics metrics = fontMetrics();
    int widest = 0;
    for (const QString &one : m_room.isEmpty() ? lines() : m_room)
        widest = std::max(widest, metrics.horizontalAdvance(one));
    constexpr int kAir = 2; // widths are rounded
    return QSize(widest + kAir, (m_lines - 1) * metrics.lineSpacing() + metrics.height())
        .grownBy(contentsMargins());
}

bool SteadyLabel::isCut() const
{
    const QStringList all = lines();
    return std::any_of(all.begin(), all.end(), [this](const QString &one) {
        return fontMetrics().horizontalAdvance(one) > contentsRect().width();
    });
}

bool SteadyLabel::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip || !isCut())
        return QLabel::event(event);
    const auto html = [](const QString &plain) {
        return plain.toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br>"));
    };
    QString says = QStringLiteral("<span>%1</span>").arg(html(text()));
    if (const QString tip = toolTip(); !tip.isEmpty())
        says += QStringLiteral("<br>") + (Qt::mightBeRichText(tip) ? tip : html(tip));
    QToolTip::showText(static_cast<QHelpEvent *>(event)->globalPos(), says, this);
    return true;
}

void SteadyLabel::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const QRect all = contentsRect();
    const Qt::Alignment across =
        QStyle::visualAlignment(layoutDirection(), alignment()) & Qt::AlignHorizontal_Mask;
    const int step = fontMetrics().lineSpacing();
    // One line stands where the alignment says; several begin at the top.
    QRect line =
        m_lines == 1 ? all : QRect(all.left(), all.top(), all.width(), fontMetrics().height());
    for (const QString &one : lines()) {
        style()->drawItemText(&painter, line, int(across) | Qt::AlignVCenter | Qt::TextSingleLine,
            palette(), isEnabled(), fontMetrics().elidedText(one, Qt::ElideRight, line.width()),
            foregroundRole());
        line.translate(0, step);
    }
}

} // namespace widgets
