// A small sign for each kind of event: every one has a shape of its own, the colour only helps.
#pragma once

#include "widgets/scope/events/log.h"

#include <QIcon>

class QPainter;
class QPalette;

namespace widgets {

QColor eventColor(EventKind kind, const QPalette &palette);
void paintEventSign(QPainter &painter, const QRectF &box, EventKind kind, const QPalette &palette);
QIcon eventIcon(EventKind kind, const QPalette &palette);

} // namespace widgets
