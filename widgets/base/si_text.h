// Quantities in SI units as people read them: with the prefix that keeps the number short (600 uH, 6.5 mWb), in the
// locale's manner. Display only.
#pragma once

#include <QString>

namespace widgets {

constexpr double kMilli = 1e3; ///< milliseconds in a second, millihenry in a henry

/// @param unit  SI without prefix, e.g. "H"; units that take no prefix (rpm, V/krpm) keep theirs. Five
///              significant digits; a dash for what is not finite.
/// @param place  the last decimal place that is shown, in the unit; 0: whatever there is
QString siText(double value, const QString &unit, double place = 0.0);

/// The number alone, short and in the locale's manner, as an entry field may hold it: no exponent, no group marks.
QString plainNumberText(double value, int significant = 5);
/// The same with fewer digits, and empty instead of a dash: "0.35", "1732", "0,0012" in German.
QString significantText(double value, int digits = 4);

} // namespace widgets
