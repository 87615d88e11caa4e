#include "lab/lent.h"

#include "base/text.h"
#include "catalog/limits.h"
#include "drive/values.h"

#include <cmath>
#include <utility>

namespace lab {

std::string typedText(const catalog::Value &value)
{
    constexpr int kFloatDigits = 9; // tell each number of 32 bits from the next one
    if (const auto *bytes = std::get_if<Bytes>(&value))
        return "\"" + hexOf(*bytes, " ") + "\"";
    if (const auto *whole = std::get_if<std::int64_t>(&value))
        return std::to_string(*whole);
    return decimalText(drive::asNumber(value).value_or(0.0), kFloatDigits);
}

std::optional<catalog::Value> typedValue(const std::string &text, catalog::ValueType type)
{
    if (type == catalog::ValueType::Raw) {
        if (text.size() < 2 || !text.starts_with("\"") || !text.ends_with("\""))
            return std::nullopt;
        auto bytes = bytesIn(std::string_view(text).substr(1, text.size() - 2));
        return bytes ? std::optional<catalog::Value>(std::move(*bytes)) : std::nullopt;
    }
    const auto number = numberIn<double>(text);
    if (!number || !catalog::typeLimits(type).holds(*number))
        return std::nullopt;
    std::optional<catalog::Value> value(*number);
    if (catalog::isInteger(type))
        value.emplace(std::int64_t{std::llround(*number)});
    return value;
}

std::vector<std::string> leftTexts(const std::vector<Lent> &lent)
{
    std::vector<std::string> texts;
    std::string all;
    for (const Lent &one : lent) {
        texts.push_back(one.name + " may hold what the experiment wrote");
        all += " " + one.name + "=" + one.held;
    }
    if (!lent.empty())
        texts.push_back("what it held before comes back with: rotorscope-cli set" + all);
    return texts;
}

std::string cutOffText(const std::string &texts)
{
    return "An experiment was cut off before it gave back what it had borrowed: " + texts;
}

} // namespace lab
