#include "catalog/limits.h"

#include "base/text.h"
#include "catalog/names.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace catalog {

namespace {

constexpr double kGreatestFloat = std::numeric_limits<float>::max();
constexpr double kGreatestGainStep = 2.0;

/// Why a whole number within the range has no meaning; empty if it has.
std::string refuseMeaning(const RegisterInfo &info, std::int64_t number)
{
    if (info.meaning == Meaning::Enumeration) {
        const auto names = namedValues(info.name);
        const bool named = std::ranges::find(names, number, &NamedValue::value) != names.end();
        return names.empty() || named ? "" : "is none of its values";
    }
    if (info.meaning == Meaning::Flags) {
        std::int64_t known = 0;
        for (const NamedValue &flag : namedFlags(info.name))
            known |= flag.value;
        return known == 0 || (number & ~known) == 0 ? "" : "has a bit that means nothing";
    }
    return {};
}

} // namespace

Limits typeLimits(ValueType type)
{
    switch (type) {
    case ValueType::U8:
        return {0.0, 255.0};
    case ValueType::S8:
        return {-128.0, 127.0};
    case ValueType::U16:
        return {0.0, 65535.0};
    case ValueType::S16:
        return {-32768.0, 32767.0};
    case ValueType::U32:
        return {0.0, 4294967295.0};
    case ValueType::S32:
        return {-2147483648.0, 2147483647.0};
    case ValueType::F32:
        return {-kGreatestFloat, kGreatestFloat};
    case ValueType::Text:
    case ValueType::Raw:
        break;
    }
    return {};
}

Limits writeLimits(const RegisterInfo &info)
{
    Limits limits = typeLimits(info.type);
    if (info.meaning == Meaning::Boolean)
        limits = {0.0, 1.0};
    if (info.least)
        limits.least = std::max(limits.least, *info.least);
    if (info.greatest)
        limits.greatest = std::min(limits.greatest, *info.greatest);
    return limits;
}

std::string refuseValue(const RegisterInfo &info, const Value &value)
{
    if (info.type == ValueType::Text)
        return "texts cannot be written";
    if (info.type == ValueType::Raw)
        return std::holds_alternative<Bytes>(value) ? "" : "needs its bytes";
    const auto number = asNumber(value);
    if (!number)
        return "not a number";
    if (!std::isfinite(*number))
        return "not a finite number";
    if (isInteger(info.type) && *number != std::nearbyint(*number))
        return "not a whole number";
    const Limits limits = writeLimits(info);
    if (!limits.holds(*number))
        return limits.greatest >= kGreatestFloat && limits.least > -kGreatestFloat
            ? "is less than " + decimalText(limits.least)
            : "out of range " + decimalText(limits.least) + " to " + decimalText(limits.greatest);
    return isInteger(info.type) ? refuseMeaning(info, static_cast<std::int64_t>(*number)) : "";
}

Caution cautionOf(
    const RegisterInfo &info, const std::optional<Value> &old, const Value &wanted, bool running)
{
    if (info.dangerous)
        return Caution::Dangerous;
    if (info.gain == Gain::None || !running)
        return Caution::None;
    const auto to = asNumber(wanted);
    const auto from = old ? asNumber(*old) : std::nullopt;
    if (!from || !to)
        return Caution::GainJump;
    if (*from == *to)
        return Caution::None;
    const double a = info.gain == Gain::Exponent ? std::exp2(*from) : *from;
    const double b = info.gain == Gain::Exponent ? std::exp2(*to) : *to;
    const double least = std::min(std::abs(a), std::abs(b)),
                 greatest = std::max(std::abs(a), std::abs(b));
    const bool turned = std::signbit(a) != std::signbit(b);
    return turned || !(greatest <= kGreatestGainStep * least) ? Caution::GainJump : Caution::None;
}

} // namespace catalog
