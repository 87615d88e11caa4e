// Reading a set-point that the user typed. Stricter than Qt's spin boxes, which read "1.234" as 1234 in German and
// "1e3" as 13: '.' and ',' both are the decimal point, group marks and exponents are refused, nothing is guessed.
#pragma once

#include "base/result.h"

#include <QString>

namespace widgets {

enum class SetpointError : std::uint8_t {
    Empty,
    NotANumber, ///< a character that has no place in a plain number, exponents included
    TwoPoints, ///< "1.234,5" or "1,234,567": a group mark, perhaps
    TooLong,
};

/// The number in `text`, e.g. "-1500", "1,5", "+ 3.25" is refused (space inside). At most 12 characters.
Result<double, SetpointError> readSetpoint(const QString &text);

/// The same for a text of any length up to `longest` characters.
Result<double, SetpointError> readPlainNumber(const QString &text, qsizetype longest);

/// The sentence for an error.
QString setpointErrorText(SetpointError error);

} // namespace widgets
