// A measured number with the interval that holds the true one in 95 of 100 cases.
#pragma once

#include <optional>

namespace lab {

struct Estimate {
    double value = 0.0;
    /// Empty: the spread is not known, as of a single value.
    std::optional<double> low, high;
    bool operator==(const Estimate &) const = default;
};

} // namespace lab
