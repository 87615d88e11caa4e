#include "lab/fields.h"

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
    const auto value = numberIn<double>(fieldOf(happening, key));
    return value && std::isfinite(*value) && std::abs(*value) < kMost ? value : std::nullopt;
}

} // namespace lab
