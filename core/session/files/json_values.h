// Values of JSON files, read as what they should be: files are foreign.
#pragma once

#include <cmath>
#include <optional>

namespace session {

/// A whole number within the range; empty for any other, and for NaN, which stands for a member that is none.
template <class Number>
std::optional<Number> wholeIn(double value, double least, double most)
{
    if (!(value >= least && value <= most) || value != std::nearbyint(value))
        return std::nullopt;
    return static_cast<Number>(value);
}

} // namespace session
