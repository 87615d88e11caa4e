// The samples of one fast signal: 16-bit codes in fixed chunks, each with its own pyramid of
// extremes (a level for every factor of 16), and the runs of ticks they belong to. 2.27 bytes a
// sample; growth never copies. The codes of full chunks and the finest level may lie in an archive, the
// oldest first; what stays in memory of them is 0.02 bytes a sample.
//
// A copy shares the chunks and is a snapshot: it reads only samples that were there when it was
// made, while the original goes on appending behind them, so a snapshot may be read in another
// thread. Only one may append. Technique: min/max mipmap as in sigrok PulseView,
// pv/data/analogsegment.cpp.
#pragma once

#include "capture/min_max_kernel.h"
#include "capture/sample_archive.h"
#include "capture/sample_memory.h"
#include "capture/tick_time.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <deque>
#include <memory>
#include <span>
#include <vector>

namespace capture {

/// Number of a sample in its column; keeps its meaning when old samples are released.
using Index = std::uint64_t;

/// Equal slices of time on a grid. Where one begins depends on its number alone: slices of two stretches of one grid
/// are the same where both have them.
struct Slices {
    double origin = 0.0; ///< seconds
    double width = 0.0; ///< seconds
    std::int64_t first = 0; ///< number of the first one
    std::size_t count = 0;

    static Slices of(double from, double to, std::size_t count)
    {
        return {from, (to - from) / static_cast<double>(count), 0, count};
    }
    /// Where slice `i` of these begins, in seconds.
    double edge(std::size_t i) const
    {
        return origin + static_cast<double>(first + static_cast<std::int64_t>(i)) * width;
    }
    bool empty() const { return count == 0 || !(width > 0); }
};

/// Samples without a gap between them.
struct Segment {
    Index first = 0;
    Index count = 0;
    Tick firstTick = 0;
    std::uint32_t step = 1; ///< ticks between two samples
    TickBase base;

    Index end() const { return first + count; }
    Tick tickOf(Index index) const
    {
        return firstTick + static_cast<Tick>(index - first) * static_cast<Tick>(step);
    }
    Nanos timeOf(Index index) const { return base.timeOf(tickOf(index)); }
    Nanos start() const { return base.timeOf(firstTick); }
    Nanos stop() const { return timeOf(end()); } ///< one step after the last sample
    double stepNanos() const { return base.tickNanos() * step; }

    /// First sample at or after `time`, in [first, end()].
    Index atOrAfter(Nanos time) const;
};

/// A search among rising things from where one is, for walks that go on by about as much each time.
/// @return  the last of `count` things that begins, of which `low` is one, as far as is known; those behind it do not
/// @param stride  how far it is likely to be, at least 1
/// @param begins  called with a number below `count`
template <class Begins>
std::size_t lastThatBegins(std::size_t low, std::size_t stride, std::size_t count, Begins begins)
{
    std::size_t high = std::min(low + stride, count); // does not
    std::size_t reach = 1;
    if (high < count && begins(high)) {
        low = high;
        while (low + reach < count && begins(low + reach)) {
            low += reach;
            reach *= 2;
        }
        high = std::min(low + reach, count);
    } else {
        while (high - low > reach && !begins(high - reach)) {
            high -= reach;
            reach *= 2;
        }
        if (high - low > reach)
            low = high - reach;
    }
    while (high - low > 1) {
        const std::size_t middle = low + (high - low) / 2;
        (begins(middle) ? low : high) = middle;
    }
    return low;
}

/// Which chunks of a column lie in an archive, or are on their way: always the oldest. Chunks are counted from the
/// first one that the column ever had.
class ArchivedChunks {
public:
    std::uint64_t handed() const { return m_handed; } ///< the oldest that is not even on its way
    /// How many of those from `first` on lie in the archive. @param first  the oldest that is kept
    std::uint64_t placedFrom(std::uint64_t first) const { return m_placed - first; }

    void handOver() { ++m_handed; }
    void place(std::uint64_t chunk)
    {
        assert(chunk == m_placed && chunk < m_handed);
        m_placed = chunk + 1;
    }
    void takeBack() { m_handed = m_placed; }
    /// @param first  the oldest that is still kept
    void release(std::uint64_t first)
    {
        m_placed = std::max(m_placed, first);
        m_handed = std::max(m_handed, first);
    }

private:
    std::uint64_t m_placed = 0;
    std::uint64_t m_handed = 0;
};

class FastColumn {
public:
    static constexpr std::size_t kChunkSamples = kSliceSamples;

    FastColumn() = default;
    /// @param memory  of several columns; a column without one gets its own
    explicit FastColumn(std::shared_ptr<SampleMemory> memory)
        : m_memory(std::move(memory))
    {
    }
    static constexpr std::size_t kBlockSamples = 256;

    bool empty() const { return m_begin == m_end; }
    Index begin() const { return m_begin; } ///< the oldest sample still kept
    Index end() const { return m_end; }
    const std::vector<Segment> &segments() const { return m_segments; }

    /// Appends behind the last sample if `tick` follows it without a gap, else starts a new
    /// segment.
    /// @param tick  of codes[0]; later than every sample before it
    void append(
        const TickBase &base, Tick tick, std::uint32_t step, std::span<const std::int16_t> codes);

    /// The next sample starts a new segment even if its tick follows the last one.
    void breakHere() { m_broken = true; }

    std::int16_t at(Index index) const;

    /// Extremes of [from, to), clipped to what is kept; exact. Cost: a few dozen reads a chunk touched, however long.
    CodeRange extremes(Index from, Index to) const;

    /// Extremes of the whole block of kBlockSamples that starts at `index`, a multiple of it; all of it must be
    /// there. One read: for searches that pass over what cannot matter.
    CodeRange blockExtremes(Index index) const;

    /// As many consecutive codes from `index` as lie in one chunk, at most `limit`; for fast
    /// sequential reading.
    std::span<const std::int16_t> codes(Index index, std::size_t limit) const;

    std::size_t pieceOf(Index index) const; ///< the segment that holds it; pieces() if none
    std::size_t pieces() const { return m_segments.size(); }
    Nanos startOf(std::size_t piece) const { return m_segments[piece].start(); }
    Nanos stopOf(std::size_t piece) const { return m_segments[piece].stop(); }
    /// First sample at or after `time`; end() if there is none.
    Index atOrAfter(Nanos time) const;
    Nanos timeOf(Index index) const { return m_segments[pieceOf(index)].timeOf(index); }

    /// Extremes of slices. Their edges are rounded to blocks of the pyramid, by less than a sixteenth of a slice and
    /// never across a gap: every sample is in exactly one slice. Those that are not at the end stay what they are while
    /// samples are appended.
    /// @param visit  called with (slice, CodeRange) for the slices that hold samples, in order
    template <class Visit>
    void slices(const Slices &slices, Visit visit) const;

    void releaseOldest(); ///< drops the oldest chunk; nothing if it is the one being filled
    bool canRelease() const { return m_chunks.size() > 1; }
    std::size_t bytes() const; ///< in memory

    // The way into an archive: the oldest full chunk that is not on its way is handed over, and what was handed over
    // first is placed first. Copies made before go on reading where they did.
    /// Of a chunk.
    static constexpr std::size_t kArchivedBytes = kSliceBytes + kSliceRanges * sizeof(CodeRange);
    /// First sample of the next one.
    Index toArchive() const { return m_archived.handed() * kChunkSamples; }
    std::uint64_t archivableBytes() const
    {
        return (m_end / kChunkSamples - m_archived.handed()) * kArchivedBytes;
    }
    std::uint64_t archivedBytes() const
    {
        return m_archived.placedFrom(m_begin / kChunkSamples) * kArchivedBytes;
    }
    static constexpr std::size_t chunkBytes() { return kArchivedBytes; } ///< of the next one
    /// Appends two stretches. Only if archivableBytes() is not 0.
    void handOver(std::vector<Stretch> &to);
    /// @param first  toArchive() before it was handed over; nothing happens if the chunk was let go since
    void place(Index first, std::span<const Stretch> where);
    void takeBack() { m_archived.takeBack(); } ///< what was handed over and not placed stays here

private:
    static constexpr std::size_t kFanOut = 16;
    static constexpr std::size_t kLevels = 3;
    static_assert(kSliceRanges == kSliceSamples / kFanOut);
    /// Of the levels above the finest.
    static constexpr std::array<std::size_t, kLevels - 1> kLevelStart{0, 256};

    // Its ranges are written before they are read; clearing them first would cost what appending does.
    struct Chunk { // NOLINT(cppcoreguidelines-pro-type-member-init)
        std::shared_ptr<const std::int16_t[]> samples;
        std::shared_ptr<const CodeRange[]> finest; ///< extremes of sixteen samples each
        std::array<CodeRange, 272> coarser; ///< the other levels, finer first
        const CodeRange *level(std::size_t number) const
        {
            return number == 0 ? finest.get() : &coarser[kLevelStart[number - 1]];
        }
        CodeRange extremes(std::size_t from, std::size_t to) const;
    };

    /// Where a walk over rising times is: what an edge needs of its segment, which changes rarely and costs divisions.
    struct Walk {
        std::size_t segment = 0;
        std::size_t stride = 1; ///< how many segments the last step took, at least one
        bool known = false;
        Nanos start = 0; ///< of the segment
        Nanos next = 0; ///< start of the one behind it; the end of all times if there is none
        double perNano = 0.0; ///< samples
        double width = 0.0; ///< of a slice, in nanoseconds
        /// Its edges are rounded to, as long as that is less than a sixteenth of a slice.
        std::uint64_t block = 1;
    };

    void appendCodes(std::span<const std::int16_t> codes);
    void addChunk();
    /// Copies into [from, to) of the last chunk and builds the extremes that are complete with it.
    void fill(const std::int16_t *codes, std::size_t from, std::size_t to);
    Index edge(Nanos wanted, Walk &walk) const;
    void seek(Nanos wanted, Walk &walk) const;
    static std::size_t inChunk(Index index)
    {
        return static_cast<std::size_t>(index % kChunkSamples);
    }
    std::size_t chunkAt(Index index) const
    {
        return static_cast<std::size_t>((index - m_begin) / kChunkSamples);
    }
    const Chunk &chunkOf(Index index) const { return *m_chunks[chunkAt(index)]; }

    std::shared_ptr<SampleMemory> m_memory;
    std::deque<std::shared_ptr<Chunk>> m_chunks;
    std::int16_t *m_filledSamples = nullptr; ///< of the last chunk, for appending
    CodeRange *m_filledRanges = nullptr;
    ArchivedChunks m_archived;
    Index m_begin = 0; ///< of the first chunk
    Index m_end = 0;
    bool m_broken = false;
    std::vector<Segment> m_segments;
};

template <class Visit>
void FastColumn::slices(const Slices &slices, Visit visit) const
{
    if (m_segments.empty() || slices.empty())
        return;
    Walk walk;
    walk.width = slices.width * kNanosPerSecond;
    Index low = edge(toNanos(slices.edge(0)), walk);
    for (std::size_t i = 0; i < slices.count && low < m_end; ++i) {
        const Index high = edge(toNanos(slices.edge(i + 1)), walk);
        if (high > low)
            visit(i, extremes(low, high));
        low = high;
    }
}

} // namespace capture
