// Capture: everything recorded, as columns. Append-only, in one thread (the GUI's or the command line's).
// Interface agreed between the drive, the scope and the exporters.
#pragma once

#include "base/time.h"
#include "capture/sample_block.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace capture {

/// Names a channel for as long as the capture lives.
using ChannelId = std::uint32_t;

struct ChannelInfo {
    ChannelId id = 0;
    catalog::RegisterId registerId = 0;
    std::string name;
    std::string unit;
    double factor = 1.0;
    double offset = 0.0;
    enum class Kind : std::uint8_t { Fast, Slow, Polled } kind = Kind::Fast;
};

/// Extremes of one drawing column, in the channel's unit; empty() where there is no sample.
struct MinMax {
    float min = std::numeric_limits<float>::infinity();
    float max = -std::numeric_limits<float>::infinity();
    bool empty() const { return min > max; }
};

} // namespace capture
