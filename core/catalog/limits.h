// What may be written to a register, whatever is connected: the range of its type, the table's range, the values that
// have a name. And which writes the user is asked about first. The board's own limits of speed and current come on top.
#pragma once

#include "catalog/register_info.h"

#include <optional>
#include <string>

namespace catalog {

/// An inclusive range of raw numbers.
struct Limits {
    double least = 0.0, greatest = 0.0;
    bool holds(double raw) const { return raw >= least && raw <= greatest; } ///< false for NaN
    bool operator==(const Limits &) const = default;
};

/// The numbers that a type can hold; for texts and structures an empty range at 0.
Limits typeLimits(ValueType type);

/// The raw numbers that a scalar register takes; for texts and structures an empty range at 0.
Limits writeLimits(const RegisterInfo &info);

/// Why a value must never be sent to this register; empty if it may. A whole number that came as a floating-point one
/// is one. For structures only the kind is looked at; their content is checked by the code that knows it.
std::string refuseValue(const RegisterInfo &info, const Value &value);

/// Why the user is asked before a write.
enum class Caution : std::uint8_t {
    None,
    Dangerous, ///< it can move or harm something at once
    GainJump, ///< a gain of a motor that runs, to more than double, less than half or the other sign
};

/// @param old      what the register holds; empty if that is not known, which counts as a jump
/// @param running  the register's motor is anywhere but at rest
Caution cautionOf(
    const RegisterInfo &info, const std::optional<Value> &old, const Value &wanted, bool running);

} // namespace catalog
