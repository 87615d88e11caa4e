// What tells the curves of runs apart: a colour, and a tick of another shape for colour-blind users.
#pragma once

#include <QColor>
#include <QPixmap>
#include <QString>

class QCPScatterStyle;

namespace widgets {

/// @param number  of the run, from 1; 64 of them differ
QColor runColor(int number, bool dark);
QCPScatterStyle runTick(int number, const QColor &color);
QString runTickName(int number); ///< for screen readers

/// A piece of a curve with its tick, as large as a line of text. @param height  pixels
QPixmap runMark(int number, bool dark, int height, double pixelRatio);

} // namespace widgets
