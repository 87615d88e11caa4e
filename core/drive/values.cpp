#include "drive/values.h"

#include "base/text.h"
#include "catalog/limits.h"

#include <cmath>

namespace drive {

using catalog::ValueType;

namespace {

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

bool sameValue(const Value &written, const Value &read)
{
    const auto a = asNumber(written), b = asNumber(read);
    if (a && b)
        return *a == *b || static_cast<float>(*a) == static_cast<float>(*b);
    return written == read;
}

Result<std::int64_t, std::string> wholeNumberFor(ValueType type, const Value &value)
{
    const auto number = wholeNumber(value);
    if (!number || !catalog::isInteger(type))
        return fail(std::string("not a whole number"));
    const catalog::Limits limits = catalog::typeLimits(type);
    if (!limits.holds(static_cast<double>(*number)))
        return fail("out of range " + std::to_string(std::llround(limits.least)) + " to "
            + std::to_string(std::llround(limits.greatest)));
    return *number;
}

std::string shortNumber(double value) { return decimalText(value, 6); }

} // namespace drive
