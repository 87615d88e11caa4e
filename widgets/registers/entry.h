// Reading what the user types into a register, and what an editor begins with. Stricter than Qt's spin boxes: '.' and
// ',' both are the decimal point, group marks and exponents are refused, a value outside the limits is not cut but
// refused, and no text gives a number that is not finite.
#pragma once

#include "base/result.h"
#include "catalog/limits.h"
#include "drive/event.h"

#include <QString>

namespace widgets {

enum class EntryError : std::uint8_t {
    Empty,
    NotANumber,
    TwoPoints, ///< "1.234,5": a group mark, perhaps
    TooLong,
    OtherUnit, ///< ends in a unit that is not this register's
    OutOfRange,
    NoSuchName, ///< of an enumeration or a flag
    NotBytes, ///< pairs of hexadecimal digits
    CannotBeTyped, ///< a text, or a structure in the unit people read
};

/// What decides how a text is read.
struct EntryRules {
    const catalog::RegisterInfo *info = nullptr;
    catalog::Scale scale;
    catalog::Limits limits; ///< raw, the board's own included
};

/// @param motor  the board's limits of the register's motor; zeros do not bound
EntryRules entryRules(const catalog::RegisterInfo &info, const catalog::Scale &scale,
    const drive::MotorLimits &motor);

/// Text in the unit people read, with the unit or without; names where the register has them. A number is brought to
/// the nearest one that the register can hold.
Result<catalog::Value, EntryError> readShownEntry(const QString &text, const EntryRules &rules);
/// Digits or 0x... as on the wire; pairs of hexadecimal digits for a structure.
Result<catalog::Value, EntryError> readRawEntry(const QString &text, const EntryRules &rules);

/// What an editor begins with: reads back to the same value.
QString shownEntryText(const catalog::Value &value, const EntryRules &rules);
QString rawEntryText(const catalog::Value &value);

/// The same value some steps up or down, as arrow keys and the wheel go; stays within the limits. Empty if it has none.
std::optional<catalog::Value> stepped(
    const catalog::Value &value, int steps, const EntryRules &rules);

/// The sentence for an error, with the range where that is what is wrong.
QString entryErrorText(EntryError error, const EntryRules &rules);

} // namespace widgets
