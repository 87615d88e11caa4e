// The look of axes, and of the small plots beside the scope, in the palette and the font of the widget that holds them.
#pragma once

class QCPAxis;
class QColor;
class QCustomPlot;
class QFont;
class QWidget;

namespace widgets {

/// Line, numbers and ticks of an axis in one colour, the small ticks quieter.
void colorAxis(QCPAxis &axis, const QColor &color);

/// The same with a faint grid, without a line at zero, and the font.
void dressAxis(QCPAxis &axis, const QColor &text, const QFont &font);

/// Background and axes; pens of graphs and items are the caller's.
void dressPlot(QCustomPlot &plot, const QWidget &like);

} // namespace widgets
