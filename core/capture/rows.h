// Channels of one rate on a common time axis, as arrays: what programs for mathematics take.
#pragma once

#include "capture/capture.h"

#include <functional>
#include <vector>

namespace capture {

struct Rows {
    std::vector<double> time; ///< seconds, rising
    /// A channel each, in its unit; NaN where it has no sample.
    std::vector<std::vector<double>> columns;
};

/// The instants at which any of the channels has a sample in the range; see splitByRate() for channels that go
/// together. Cost: 8 bytes a number, and a search a sample.
/// @param proceed  told now and then how many rows there are and how many there are at least in the end; false: these
///                 are enough
Rows rowsOf(const Snapshot &channels, const std::optional<TimeSpan> &range = {},
    const std::function<bool(std::size_t rows, std::size_t least)> &proceed = {});

} // namespace capture
