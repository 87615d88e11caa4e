// The two levels of a signal and where it crosses between them: what frequency, duty, rise and phase rest on.
#pragma once

#include "scope/measurement.h"
#include "scope/sample_range.h"

namespace scope {

/// Where a signal stays low and high. If it dwells there (half of its upper or lower samples within 5 % of the height
/// around the most frequent value), the mean of those; else, as with a sine, its extreme.
struct SignalLevels {
    double base = 0.0;
    double top = 0.0;
    double height() const { return top - base; }
    double at(double share) const { return base + share * (top - base); }
};

/// nullopt if there are fewer than 3 samples or all are the same. Cost: two passes over the samples.
std::optional<SignalLevels> findLevels(const SampleRange &range);

/// Crossings of one level, upwards and downwards, in seconds since range.from().
struct Crossings {
    std::vector<double> rising;
    std::vector<double> falling;
};

/// Crossings kept at most, the oldest first; more make no mean more exact than a float can show.
constexpr std::size_t kMostCrossings = 1'000'000;

/// @param hysteresis  how far beyond the level the value has to have been, as with triggers
/// Interpolated between fast samples; at the sample where values hold.
Crossings findCrossings(const SampleRange &range, double level, double hysteresis);

/// A transition that is complete: from the last crossing of one level to the first of the other one.
struct Transition {
    double from = 0.0; ///< seconds since range.from()
    double to = 0.0;
};

/// The first complete transition from `start` to `end`, up if start < end.
std::optional<Transition> findTransition(const SampleRange &range, double start, double end);

} // namespace scope
