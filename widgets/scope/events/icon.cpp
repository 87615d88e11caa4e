#include "widgets/scope/events/icon.h"

#include "widgets/base/trace_colors.h"

#include <QPainter>
#include <QPalette>

namespace widgets {

namespace {
constexpr int kIconSize = 32;

QPointF in(const QRectF &box, double x, double y)
{
    return {box.left() + x * box.width(), box.top() + y * box.height()};
}

void paintFlag(QPainter &painter, const QRectF &box, const QColor &color)
{
    painter.setPen(QPen(color, box.width() * 0.12));
    painter.drawLine(in(box, 0.22, 0.05), in(box, 0.22, 0.98));
    painter.setPen(Qt::NoPen);
    painter.drawPolygon(QPolygonF{in(box, 0.22, 0.05), in(box, 0.95, 0.30), in(box, 0.22, 0.58)});
}

/// A warning triangle with its mark of exclamation.
void paintFault(QPainter &painter, const QRectF &box, const QPalette &palette)
{
    painter.drawPolygon(QPolygonF{in(box, 0.5, 0.02), in(box, 1.0, 0.95), in(box, 0.0, 0.95)});
    painter.setPen(QPen(palette.color(QPalette::Base), box.width() * 0.14));
    painter.drawLine(in(box, 0.5, 0.38), in(box, 0.5, 0.62));
    painter.drawPoint(in(box, 0.5, 0.80));
}
} // namespace

QColor eventColor(EventKind kind, const QPalette &palette)
{
    const bool dark = isDark(palette);
    switch (kind) {
    case EventKind::Fault:
        return dark ? QColor(0xff, 0x6b, 0x5e) : QColor(0xc0, 0x1f, 0x1f);
    case EventKind::Loss:
        return dark ? QColor(0xf2, 0x9a, 0x3a) : QColor(0xb3, 0x5c, 0x00);
    case EventKind::Recovery:
        return dark ? QColor(0x1f, 0xc7, 0x9a) : QColor(0x00, 0x7a, 0x58);
    case EventKind::State:
        return dark ? QColor(0x4f, 0xa8, 0xe8) : QColor(0x00, 0x5f, 0x9e);
    case EventKind::Write:
        return dark ? QColor(0xdb, 0x8f, 0xba) : QColor(0x97, 0x3f, 0x70);
    case EventKind::Marker:
    case EventKind::Command:
        break;
    }
    return palette.color(QPalette::Text);
}

void paintEventSign(QPainter &painter, const QRectF &box, EventKind kind, const QPalette &palette)
{
    const QColor color = eventColor(kind, palette);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    const QPen stroke(color, box.width() * 0.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    switch (kind) {
    case EventKind::Command: // a triangle that plays
        painter.drawPolygon(
            QPolygonF{in(box, 0.12, 0.05), in(box, 0.95, 0.5), in(box, 0.12, 0.95)});
        break;
    case EventKind::Write: // a diamond
        painter.drawPolygon(
            QPolygonF{in(box, 0.5, 0.0), in(box, 1.0, 0.5), in(box, 0.5, 1.0), in(box, 0.0, 0.5)});
        break;
    case EventKind::State: // a disc
        painter.drawEllipse(box.adjusted(
            box.width() * 0.1, box.height() * 0.1, -box.width() * 0.1, -box.height() * 0.1));
        break;
    case EventKind::Marker:
        paintFlag(painter, box, color);
        break;
    case EventKind::Recovery: // a tick
        painter.setPen(stroke);
        painter.setBrush(Qt::NoBrush);
        painter.drawPolyline(QPolygonF{in(box, 0.1, 0.55), in(box, 0.4, 0.85), in(box, 0.9, 0.18)});
        break;
    case EventKind::Loss: // a cross
        painter.setPen(stroke);
        painter.drawLine(in(box, 0.15, 0.15), in(box, 0.85, 0.85));
        painter.drawLine(in(box, 0.85, 0.15), in(box, 0.15, 0.85));
        break;
    case EventKind::Fault:
        paintFault(painter, box, palette);
        break;
    }
    painter.restore();
}

QIcon eventIcon(EventKind kind, const QPalette &palette)
{
    QPixmap pixmap(kIconSize, kIconSize);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paintEventSign(painter, QRectF(4, 4, kIconSize - 8, kIconSize - 8), kind, palette);
    return QIcon(pixmap);
}

} // namespace widgets
