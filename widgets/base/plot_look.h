// The look of the small plots beside the scope, in the palette and the font of the widget that holds them.
#pragma once

class QCustomPlot;
class QWidget;

namespace widgets {

/// Background, axes and a faint grid without a line at zero; pens of graphs and items are the caller's.
void dressPlot(QCustomPlot &plot, const QWidget &like);

} // namespace widgets
