// The way that the Tab key takes through a window whose parts are made in another order than they are read in.
#pragma once

#include <QList>

class QWidget;

namespace widgets {

/// Puts what lies in `parts` first, part by part; everything keeps its place within its part, all others come after them.
void orderTabs(QWidget &window, const QList<QWidget *> &parts);

} // namespace widgets
