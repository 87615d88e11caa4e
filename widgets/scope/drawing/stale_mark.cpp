#include "widgets/scope/drawing/stale_mark.h"

#include "widgets/base/look/section_head.h"
#include "widgets/scope/view.h"

#include <QPainter>

namespace widgets {

StaleMark::StaleMark(const ScopeView &scope, QWidget *parent)
    : QWidget(parent)
    , m_scope(scope)
{
    setObjectName(QStringLiteral("staleMark"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setVisible(false);
}

void StaleMark::say(const QString &why)
{
    if (why == m_why)
        return;
    m_why = why;
    setAccessibleName(why);
    setVisible(!why.isEmpty());
    raise();
    update();
}

void StaleMark::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    QColor faint = palette().color(QPalette::Text);
    faint.setAlpha(60);
    for (int plot = 0; plot < m_scope.plotCount(); ++plot)
        painter.fillRect(m_scope.plotRect(plot), QBrush(faint, Qt::BDiagPattern));

    painter.setFont(inBold(font()));
    const QRect area = m_scope.plotRect(0);
    QRect box = painter.fontMetrics().boundingRect(area, Qt::AlignCenter, m_why);
    box.adjust(-10, -5, 10, 5);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::Text));
    painter.setBrush(palette().brush(QPalette::Base));
    painter.drawRoundedRect(QRectF(box).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    painter.drawText(box, Qt::AlignCenter, m_why);
}

} // namespace widgets
