#include "drive/values.h"

#include <cmath>

namespace drive {

using catalog::ValueType;

namespace {

struct Range {
    std::int64_t min, max;
};
Range rangeOf(ValueType type)
{
    switch (type) {
    case ValueType::U8:
        return {0, 0xFF};
    case ValueType::S8:
        return {-0x80, 0x7F};
    case ValueType::U16:
        return {0, 0xFFFF};
    case ValueType::S16:
        return {-0x8000, 0x7FFF};
    case ValueType::U32:
        return {0, 0xFFFFFFFF};
    case ValueType::S32:
        return {-0x80000000LL, 0x7FFFFFFF};
    default:
        return {0, 0};
    }
}

/// A whole number, also where it came as a floating-point one.
std::optional<std::int64_t> wholeNumber(const Value &value)
{
    if (const auto *number = std::get_if<std::int64_t>(&value))
        return *number;
    const auto *number = std::get_if<double>(&value);
    if (number == nullptr || !std::isfinite(*number) || std::abs(*number) > 9e15
        || *number != std::nearbyint(*number))
        return std::nullopt;
    return static_cast<std::int64_t>(*number);
}

} // namespace

std::optional<double> asNumber(const Value &value)
{
    if (const auto *whole = std::get_if<std::int64_t>(&value))
        return static_cast<double>(*whole);
    if (const auto *real = std::get_if<double>(&value))
        return *real;
    return std::nullopt;
}

Result<std::int64_t, std::string> wholeNumberFor(ValueType type, const Value &value)
{
    const auto number = wholeNumber(value);
    if (!number)
        return fail(std::string("not a whole number"));
    const Range range = rangeOf(type);
    if (*number < range.min || *number > range.max)
        return fail(
            "out of range " + std::to_string(range.min) + " to " + std::to_string(range.max));
    return *number;
}

} // namespace drive
