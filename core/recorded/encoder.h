// Encoder: entries in, blocks of a recording out. It owns no file and reads no clock.
//
// Samples that follow each other without a gap are gathered to long columns, and bytes of one direction to long pieces,
// until one of the bounds of Config is reached; then, and with flush(), they become blocks. The writer of the file
// writes each block whole and in order.
//
// Call order: head() first, then add() and flush() with takeBlocks() after each, end() last.
#pragma once

#include "recorded/overview.h"

#include <map>
#include <optional>
#include <utility>

namespace recorded {

/// A piece of the file that is written whole. Reported as written only when all of it is.
struct Block {
    Bytes bytes;
    std::uint64_t samples = 0; ///< in it
};

class Encoder {
public:
    struct Config {
        std::size_t blockBytes = 65536; ///< samples gathered until they are a block
        Nanos gatherSamples = 250'000'000; ///< nanoseconds, no longer than that
        std::size_t linkBytes = 16384; ///< bytes of one direction until they are a block
        Nanos gatherLink = 20'000'000; ///< and so long; a block has the time of its first byte
        std::size_t repeatBytes = 4 << 20; ///< descriptions are written again after so many bytes
    };

    explicit Encoder(Begin begin)
        : Encoder(std::move(begin), Config{})
    {
    }
    Encoder(Begin begin, Config config);

    /// What the file begins with. The place of the end is in it: see endInReserve().
    Block head();

    /// @param at  when it was told; samples keep their own ticks
    /// False: the entry is too long for a block, or contradicts itself, and is left out.
    bool add(Nanos at, const Entry &entry);

    /// Makes blocks of what was gathered before `now` - the bounds; with flushAll() of all of it.
    void flush(Nanos now);
    void flushAll();
    /// When flush() has something to do; empty: nothing was gathered.
    std::optional<Nanos> due() const;

    /// What a reader shows before it has read the samples, a hundredth of the file at most; ahead of end().
    void addOverview(Nanos at);
    /// The last block. Numbers in `end` are put in here.
    void end(Nanos at, End end);

    [[nodiscard]] std::vector<Block> takeBlocks() { return std::exchange(m_blocks, {}); }

    /// A full disk takes no further block. This one goes over the place that head() kept: same length, so no room is
    /// needed. @param end  its text is cut to what fits
    struct Overwrite {
        std::size_t offset = 0;
        Bytes bytes;
    };
    Overwrite endInReserve(Nanos at, End end) const;

private:
    struct GatheredLink {
        Nanos since = 0;
        LinkBytes what;
    };

    void addSamples(Nanos at, const capture::SampleBlock &block);
    void addLink(Nanos at, const LinkBytes &link);
    void remember(const Entry &entry);
    bool continues(const capture::SampleBlock &block) const;
    void flushSamples();
    void flushLink();
    bool emitEntry(Nanos at, const Entry &entry);
    void repeatWhereDue(Nanos at);
    void emitPayload(Nanos at, Bytes payload, std::uint64_t samples);
    void push(Bytes bytes, std::uint64_t samples);

    Begin m_begin;
    Config m_config;
    std::vector<Block> m_blocks;
    std::uint32_t m_number = 0; ///< of the next block
    std::uint64_t m_samples = 0; ///< in all blocks
    std::size_t m_sinceRepeat = 0; ///< bytes
    std::size_t m_bytes = 0; ///< in all blocks
    OverviewMaker m_overview;
    std::size_t m_reserveAt = 0; ///< offset of the kept place
    std::optional<capture::StreamLayout> m_layout;
    std::map<RegisterId, PolledRegister> m_polled;
    /// Fast samples: signal after signal in m_columns.
    std::optional<capture::SampleBlock> m_gathered;
    std::vector<std::vector<std::int16_t>> m_columns; ///< one a signal
    std::size_t m_gatheredBytes = 0;
    Nanos m_gatheredSince = 0;
    std::optional<GatheredLink> m_link;
};

} // namespace recorded
