// Samples on their way from a drive to the store: what is streamed, and the values of one packet.
//
// Time is a tick: the board's count of control periods, unwrapped to 64 bits, exact. Seconds follow
// from the layout:
//   t = originSeconds + tick / tickHz
#pragma once

#include "catalog/register_info.h"

#include <cstdint>
#include <string>
#include <vector>

namespace capture {

using Tick = std::int64_t;
using StreamId = std::uint32_t;

struct StreamSignal {
    catalog::RegisterId id = 0;
    std::string name;
    std::string unit; ///< of the shown value
    double factor = 1.0; ///< shown = (stored + offset) * factor
    double offset = 0.0; ///< 32768 for unsigned 16-bit signals, which are stored signed; else 0
    bool real = false; ///< slow signals: a value is the bits of a 32-bit float
    bool operator==(const StreamSignal &) const = default;
};

struct StreamLayout {
    StreamId id = 0; ///< a new one for each configuration that took effect
    double tickHz = 0.0;
    /// Time of tick 0 on the session's axis; the same as long as the board is not reset.
    double originSeconds = 0.0;
    std::uint32_t fastStep = 1; ///< ticks between two fast samples
    std::vector<StreamSignal> fast;
    std::vector<StreamSignal> slow;
    bool ticksAreControlPeriods = true; ///< false: a tick only measures time
    bool empty() const { return fast.empty() && slow.empty(); }
    bool operator==(const StreamLayout &) const = default;
};

/// Values of the slow signals at one instant.
struct SlowGroup {
    Tick tick = 0; ///< that of the fast block it follows
    std::vector<std::int32_t> values; ///< one a slow signal
};

/// One packet's worth. Fast samples are at firstTick + i * fastStep; nothing is between this block
/// and the one before it if lostTicks is not 0.
struct SampleBlock {
    StreamId stream = 0;
    Tick firstTick = 0;
    std::uint32_t count = 0; ///< samples a fast signal
    /// Signal after signal: sample i of signal s is fast[s * count + i].
    std::vector<std::int16_t> fast;
    std::vector<SlowGroup> slow;
    Tick lostTicks = 0; ///< ticks missing before firstTick since the block before it of this stream
};

/// Numbers in a block, fast and slow.
inline std::uint64_t samplesOf(const SampleBlock &block)
{
    std::uint64_t count = block.fast.size();
    for (const SlowGroup &group : block.slow)
        count += group.values.size();
    return count;
}

} // namespace capture
