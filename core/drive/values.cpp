#include "drive/values.h"

#include "catalog/limits.h"

#include <cmath>

namespace drive {

using catalog::ValueType;

bool sameValue(const Value &written, const Value &read)
{
    const auto a = asNumber(written), b = asNumber(read);
    if (a && b)
        return *a == *b || static_cast<float>(*a) == static_cast<float>(*b);
    return written == read;
}

Result<std::int64_t, std::string> wholeNumberFor(ValueType type, const Value &value)
{
    const auto number = asNumber(value);
    if (!number || !catalog::isInteger(type) || !std::isfinite(*number)
        || *number != std::nearbyint(*number))
        return fail(std::string("not a whole number"));
    const catalog::Limits limits = catalog::typeLimits(type);
    if (!limits.holds(*number))
        return fail("out of range " + std::to_string(std::llround(limits.least)) + " to "
            + std::to_string(std::llround(limits.greatest)));
    return static_cast<std::int64_t>(*number);
}

} // namespace drive
