// Ticks in steps of 1, 2 and 5, never more than asked for however far the picture is zoomed, with labels in the user's
// language. The numbers are here and can be tested alone; axis_ticker.h hands them to the plot.
#pragma once

#include <QLocale>
#include <QString>
#include <QVector>

namespace widgets {

/// The least that a value axis shows of a signal, in its unit: so much that the noise of a few digits looks like what
/// it is. @param digit  what one digit is worth; 0 if that is not known
double leastSpan(const QString &unit, double digit);

/// The smallest step of the form 1, 2 or 5 times a power of ten that cuts `span` into at most `most` pieces.
double tickStep(double span, int most);

/// That step for an axis of values from `from` to `to`: a finer one where fewer than three of its multiples would be
/// seen and there is room for those of the next.
/// @param room  for so many labels, close together
double valueStep(double from, double to, int most, int room);

/// The value of the form 1, 2 or 5 times a power of ten that is `steps` of these above (below 0: under) the one nearest
/// to `scale`; always another than `scale` for steps that are not 0.
double steppedScale(double scale, int steps);

/// Multiples of `step` in [from, to]; at most 1000, whatever is asked for.
QVector<double> ticksIn(double from, double to, double step);

/// How many pieces small ticks cut a step of tickStep() into, each again of the form 1, 2 or 5: four of a 2, else five.
int piecesOf(double step);

/// Where the small ticks in [from, to] are, which are no multiples of `step`; at most 1000.
QVector<double> smallTicksIn(double from, double to, double step);

/// A value with as many digits as the step shows, e.g. "1.50" for steps of 0.05.
QString valueLabel(double value, double step, const QLocale &locale);

/// What a division is worth, e.g. "0.5 A/div". @param unit  empty for a plain number
QString perDivision(double step, const QString &unit, const QLocale &locale);

/// The same for times, e.g. "10 ms/div".
QString timePerDivision(double step, const QLocale &locale);

/// A time with an SI prefix that suits the larger end of the range, e.g. "12.5 ms".
QString timeLabel(double seconds, double step, double largest, const QLocale &locale);

} // namespace widgets
