// Readings of the scope as text: exact times, their inverse, values with the digits that a trace deserves.
#pragma once

#include <QLocale>
#include <QString>

#include <optional>

namespace widgets {

/// A time or a difference of times to a tenth of a microsecond, to a microsecond from one second on, or to eight digits
/// if that is coarser, e.g. "18.7500 ms", "12.345679 s".
QString exactTime(double seconds, const QLocale &locale);

/// How long something took, as far as a program that was told of it knows: three or four digits, nothing below 0.1 ms.
QString spanTime(double seconds, const QLocale &locale);

/// The inverse of a time in five digits, e.g. "53.333 Hz", "1.6000 kHz"; a dash for no time at all.
QString inverseTime(double seconds, const QLocale &locale);

/// A value in steps of `step` with its unit; "no sample" where there is none.
QString readingText(
    std::optional<double> value, double step, const QString &unit, const QLocale &locale);

} // namespace widgets
