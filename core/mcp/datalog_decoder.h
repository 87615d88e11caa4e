// ASYNC payloads to sample blocks. Knows every configuration that may still be on its way, by its mark, and decodes a
// packet only with its own. What does not fit exactly is counted and skipped: no sample is ever guessed.
//
// Call order: expect() with each configuration when it is sent, decode() with each payload; a new one when the board
// was reset.
#pragma once

#include "capture/sample_block.h"
#include "mcp/datalog.h"

#include <optional>
#include <vector>

namespace mcp {

/// Which signals are unsigned; missing entries are signed. Unsigned fast samples are stored less 32768.
struct Signedness {
    std::vector<bool> fastUnsigned;
    std::vector<bool> slowUnsigned;
};

/// A packet's blocks without any time keeping: samples in SampleBlock's order, ticks as the packet has them.
/// False if the length does not fit. Shared with the trace decoder.
/// @param block  all of it is written but the stream; what it holds of an earlier packet is room for this one
bool decodeBlocks(const DatalogConfig &config, const DatalogLayout &layout,
    const Signedness &signedness, ByteView payload, capture::SampleBlock &block);

class DatalogDecoder {
public:
    struct Stats {
        std::uint64_t packets = 0; ///< decoded
        std::uint64_t otherId = 0; ///< async id not 0: some other service
        std::uint64_t unknownMark = 0;
        std::uint64_t badLength = 0; ///< fits no number of blocks
        std::uint64_t badTime = 0; ///< timestamp not yet believed
        std::uint64_t lostTicks = 0;
        std::uint64_t timeRestarts = 0; ///< the timestamp went back and stayed there

        std::uint64_t skipped() const { return otherId + unknownMark + badLength + badTime; }
    };

    /// @param tickHz  control periods a second; a jump of more than 10 s of them needs two consistent packets
    explicit DatalogDecoder(double tickHz);

    /// From now on packets with config.mark may come. Earlier configurations stay until one of this mark was seen.
    void expect(capture::StreamId stream, const DatalogConfig &config, Signedness signedness = {});

    std::optional<capture::SampleBlock> decode(ByteView payload);
    /// The same into a block that is used again, without an allocation once it has its size; what is in it where this
    /// returns false means nothing.
    bool decode(ByteView payload, capture::SampleBlock &block);

    /// Counts up each time the ticks of the board began anew: ticks of different epochs cannot be compared.
    unsigned epoch() const { return m_epoch; }
    const Stats &stats() const { return m_stats; }

private:
    struct Known {
        capture::StreamId stream = 0;
        DatalogConfig config;
        DatalogLayout layout;
        Signedness signedness;
    };
    /// A time axis that a packet has proposed.
    struct Clock {
        std::uint32_t expected = 0; ///< timestamp of the block after the last
        capture::Tick tick = 0; ///< the same, unwrapped
    };

    Known *find(std::uint8_t mark);
    bool place(capture::SampleBlock &block, std::uint32_t timestamp, const Known &known,
        std::size_t blocks);
    void forgetOlderThan(const Known &known);

    double m_tickHz;
    std::vector<Known> m_known; ///< oldest first
    std::optional<capture::StreamId> m_lastStream;
    std::optional<Clock> m_clock;
    std::optional<std::uint32_t> m_doubtful; ///< next timestamp if the strange packet was right
    unsigned m_epoch = 0;
    Stats m_stats;
};

} // namespace mcp
