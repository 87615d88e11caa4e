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

/// What every plot needs first. It is drawn with as many pixels as its screen has, also after the window was moved to
/// another one: the library asks once, when the plot is made, and then of the first screen. And all of it lies in one
/// picture: the library keeps a second one for its rectangle of selection, which is not drawn here, and lays it over
/// the first each time.
void setUpPlot(QCustomPlot &plot);

/// Background and axes; pens of graphs and items are the caller's.
void dressPlot(QCustomPlot &plot, const QWidget &like);

} // namespace widgets
