#include "lab/fields.h"

#include <charconv>
#include <cmath>

namespace lab {

std::string fieldOf(const record::Happening &happening, std::string_view key)
{
    for (const auto &[name, value] : happening.fields)
        if (name == key)
            return value;
    return {};
}

std::optional<double> numberOf(const record::Happening &happening, std::string_view key)
{
    constexpr double kMost = 1e9;
    const std::string text = fieldOf(happening, key);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(value) && std::abs(value) < kMost ? std::optional(value)
                                                                    : std::nullopt;
}

} // namespace lab
