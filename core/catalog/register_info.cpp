#include "catalog/register_info.h"

#include "base/text.h"

#include <algorithm>

namespace catalog {

std::optional<Effect> effectOf(std::string_view word)
{
    static constexpr Word<Effect> kWords[] = {{"kept", Effect::Kept},
        {"reference", Effect::Reference}, {"mode", Effect::Mode}, {"unbounded", Effect::Unbounded},
        {"command", Effect::Command}, {"board", Effect::Board}};
    const Effect *effect = findWord(kWords, word);
    return effect == nullptr ? std::nullopt : std::optional(*effect);
}

std::optional<double> asNumber(const Value &value)
{
    if (const auto *whole = std::get_if<std::int64_t>(&value))
        return static_cast<double>(*whole);
    if (const auto *real = std::get_if<double>(&value))
        return *real;
    return std::nullopt;
}

Value onWire(const RegisterInfo &info, const Value &value)
{
    const auto *number = std::get_if<std::int64_t>(&value);
    const auto row = std::ranges::find_if(info.wire,
        [&](const WireDigits &one) { return number != nullptr && one.number == *number; });
    return row == info.wire.end() ? value : Value(row->digits);
}

std::optional<Value> fromWire(const RegisterInfo &info, const Value &value)
{
    const auto *digits = std::get_if<std::int64_t>(&value);
    if (info.wire.empty() || digits == nullptr)
        return value;
    const auto row = std::ranges::find(info.wire, *digits, &WireDigits::digits);
    return row == info.wire.end() ? std::nullopt : std::optional(Value(row->number));
}

bool isInteger(ValueType type) { return type <= ValueType::S32; }

std::size_t widthOf(ValueType type)
{
    switch (type) {
    case ValueType::U8:
    case ValueType::S8:
        return 1;
    case ValueType::U16:
    case ValueType::S16:
        return 2;
    case ValueType::U32:
    case ValueType::S32:
    case ValueType::F32:
        return 4;
    case ValueType::Text:
    case ValueType::Raw:
        break;
    }
    return 0;
}

} // namespace catalog
