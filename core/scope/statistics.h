// Mean, spread and extremes of a measurement over many captures, one number at a time, without keeping them.
// Numerically stable however large the mean is beside the spread. Source: B. P. Welford, Technometrics 4 (1962), 419.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace scope {

class Statistics {
public:
    /// A capture that gave no number (nullopt, or not a finite one) is counted apart.
    void add(std::optional<double> value)
    {
        if (!value || !std::isfinite(*value)) {
            ++m_missing;
            return;
        }
        ++m_count;
        const double before = *value - m_mean;
        m_mean += before / static_cast<double>(m_count);
        m_squares += before * (*value - m_mean);
        m_min = std::min(m_min, *value);
        m_max = std::max(m_max, *value);
        m_last = value;
    }
    void clear() { *this = {}; }

    std::uint64_t count() const { return m_count; }
    std::uint64_t missing() const { return m_missing; }
    std::optional<double> last() const { return m_last; }
    std::optional<double> mean() const { return whenAtLeast(1, m_mean); }
    std::optional<double> min() const { return whenAtLeast(1, m_min); }
    std::optional<double> max() const { return whenAtLeast(1, m_max); }
    /// Of the sample (divided by n - 1); nullopt with fewer than two.
    std::optional<double> sigma() const
    {
        return whenAtLeast(2, std::sqrt(m_squares / (static_cast<double>(m_count) - 1.0)));
    }

private:
    std::optional<double> whenAtLeast(std::uint64_t least, double value) const
    {
        return m_count >= least ? std::optional(value) : std::nullopt;
    }

    std::uint64_t m_count = 0;
    std::uint64_t m_missing = 0;
    double m_mean = 0.0;
    double m_squares = 0.0; ///< of the distances from the mean
    double m_min = std::numeric_limits<double>::infinity();
    double m_max = -std::numeric_limits<double>::infinity();
    std::optional<double> m_last;
};

} // namespace scope
