// What a few repeated measurements say together. Pure functions; values that are no numbers are the caller's to leave
// out.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace lab {

/// A measured number with the interval that holds the true one in 95 of 100 cases.
struct Estimate {
    double value = 0.0;
    /// Empty: the spread is not known, as of a single value.
    std::optional<double> low, high;
    bool operator==(const Estimate &) const = default;
};

/// The last decimal place that is shown of it, e.g. 0.001: that of the second digit of half of the interval. 0: the
/// interval is not known, or has no width.
double lastPlaceOf(const Estimate &estimate);

/// What an interval of 95 % has to either side, in standard errors that were taken from so many degrees of freedom.
double studentOf(std::size_t freedom);

/// Mean with its 95 % interval by Student's t. Empty for no value; without an interval for one.
std::optional<Estimate> meanOf(std::span<const double> values);

/// The middle between the means of two kinds of measurement, such as steps up and down, which differ by more than
/// chance: its interval tells of the spread inside each kind alone. As meanOf() where one kind is empty.
std::optional<Estimate> meanOfBoth(std::span<const double> one, std::span<const double> other);

/// With an interval. @param scale  the share by which what it is counted in is unsure besides
Estimate withScale(const Estimate &own, double scale);

double medianOf(std::vector<double> values); ///< of at least one

/// Places of the values further from the median than 3.5 of its deviations, as a normal spread would have them (1.4826
/// times the median deviation). They are named to the user, never left out of a mean.
/// @param resolution  differences up to it are none, so that equal values and one that is a digit off are no outlier
std::vector<std::size_t> outliersOf(std::span<const double> values, double resolution);

} // namespace lab
