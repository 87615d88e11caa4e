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
    if (lines == m_lines)
        return;
    m_lines = lines;
    updateGeometry();
    update();
}

int SteadyLabel::linesFor(const QString &text) const
{
    int count = 0;
    for (QString left : text.split(QLatin1Char('\n')))
        do {
            ++count;
            left = left.mid(fittingWords(left, contentsRect().width())).trimmed();
        } while (!left.isEmpty());
    return count;
}

void SteadyLabel::setSelectable(bool selectable)
{
    if (selectable == this->selectable())
        return;
    setTextInteractionFlags(selectable ? Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard
                                       : Qt::NoTextInteraction);
    setFocusPolicy(selectable ? Qt::StrongFocus : Qt::NoFocus);
    setWordWrap(selectable);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
}

QStringList SteadyLabel::lines() const
{
    QStringList left = text().split(QLatin1Char('\n')), all;
    const int width = contentsRect().width();
    while (!left.isEmpty()) {
        const bool last = all.size() == m_lines - 1;
        QString line = last ? left.join(QLatin1Char(' ')) : left.takeFirst();
        if (last)
            left.clear();
        // A paragraph goes on where those behind it leave lines over.
        else if (all.size() + left.size() < m_lines - 1)
            if (const int fits = fittingWords(line, width); fits < line.size()) {
                left.prepend(line.mid(fits).trimmed());
                line.truncate(fits);
            }
        all.append(line);
    }
    return all;
}

/// The length of the words that a line of this width holds; of its whole text where not even one fits.
int SteadyLabel::fittingWords(const QString &line, int width) const
{
    const QFontMetrics metrics = fontMetrics();
    if (metrics.horizontalAdvance(line) <= width)
        return static_cast<int>(line.size());
    int fits = 0;
    for (qsizetype space = line.indexOf(QLatin1Char(' ')); space > 0;
         space = line.indexOf(QLatin1Char(' '), space + 1)) {
        if (metrics.horizontalAdvance(line.left(space)) > width)
            break;
        fits = static_cast<int>(space);
    }
    return fits > 0 ? fits : static_cast<int>(line.size());
}

QSize SteadyLabel::sizeHint() const
{
    ensurePolished();
    const QFontMetrics metrics = fontMetrics();
    int widest = 0;
    for (const QString &one : m_room.isEmpty() ? text().split(QLatin1Char('\n')) : m_room)
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

void SteadyLabel::paintEvent(QPaintEvent *event)
{
    if (selectable() && !isCut())
        return QLabel::paintEvent(event); // which shows what is marked
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
