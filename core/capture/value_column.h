// The samples of one slow or polled signal, or of a computed or imported one: an instant and a number each, in chunks
// with the extremes of every 128, 512 and of all. A full chunk at equal steps keeps no instants, and one of values that
// repeat, as all do that came from 16 bits, keeps their places in a table: 2.2 bytes a sample where both hold, else up
// to 16. Values hold until the next one, at most to the end of their run.
//
// A copy shares the samples and is a snapshot, as with FastColumn: only one may append. Full chunks may lie in an
// archive.
#pragma once

#include "capture/fast_column.h"
#include "capture/value_table.h"

#include <limits>

namespace capture {

/// empty() where there is no sample.
template <class T>
struct Extremes {
    T min = std::numeric_limits<T>::infinity();
    T max = -std::numeric_limits<T>::infinity();
    bool empty() const { return min > max; }
    void include(Extremes other)
    {
        min = std::min(min, other.min);
        max = std::max(max, other.max);
    }
};
using MinMax = Extremes<float>; ///< of one drawing column, in the channel's unit
using ValueRange = Extremes<double>; ///< of values as they are

/// Values without a gap between them.
struct Run {
    Index first = 0;
    Index count = 0;
    Nanos holdUntil = 0; ///< how long the last value is known to hold
    Index end() const { return first + count; }
};

class ValueColumn {
public:
    static constexpr std::size_t kChunkSamples = 4096;
    static constexpr std::size_t kBlockSamples = 128; ///< with extremes of their own
    static constexpr std::size_t kMostSampleBytes = sizeof(Nanos) + sizeof(double);

    bool empty() const { return begin() == m_end; }
    Index begin() const { return m_released * kChunkSamples; }
    Index end() const { return m_end; }
    const std::vector<Run> &runs() const { return m_runs; }

    /// @param time       later than every instant before it
    /// @param holdUntil  how long the value certainly holds if nothing follows
    void append(Nanos time, double value, Nanos holdUntil)
    {
        append(std::span(&time, 1), std::span(&value, 1), holdUntil);
    }
    /// Several without a gap between them, as a packet brings them.
    /// @param times   rising, the first later than every instant before it
    /// @param values  as many
    void append(std::span<const Nanos> times, std::span<const double> values, Nanos holdUntil);

    /// The last value is still true at `time`; nothing if the run is broken.
    void extendHold(Nanos time);

    /// The next value starts a new run.
    void breakHere() { m_broken = true; }
    /// The same where polling has ended: the last value holds no longer than the one before it did.
    void endHere();

    Nanos lastTime() const { return m_lastTime; } ///< of the newest value; 0 if there is none
    Nanos timeOf(Index index) const { return chunkOf(index).timeOf(inChunk(index)); }
    double at(Index index) const { return valueIn(chunkOf(index), inChunk(index)); }
    std::size_t pieceOf(Index index) const; ///< the run that holds it; pieces() if none
    std::size_t pieces() const { return m_runs.size(); }
    Nanos startOf(std::size_t piece) const { return timeOf(m_runs[piece].first); }
    Nanos stopOf(std::size_t piece) const { return m_runs[piece].holdUntil; }

    Index atOrAfter(Nanos time) const; ///< first value at or after `time`; end() if there is none
    /// Of [from, to), clipped to what is kept. Cost: a read a chunk, and some of its two ends.
    ValueRange extremes(Index from, Index to) const;
    /// Of the whole block that begins there; all of it has to be there. Cost: no sample is read.
    const ValueRange &blockExtremes(Index from) const
    {
        return chunkOf(from).ranges[static_cast<std::ptrdiff_t>(inChunk(from) / kBlockSamples)];
    }

    /// Extremes of slices, as of a FastColumn: edges are rounded by less than a sixteenth of a slice, and every value
    /// is in exactly one.
    /// @param visit  called with (slice, ValueRange) for the slices that hold values, in order
    template <class Visit>
    void slices(const Slices &slices, Visit visit) const;

    void releaseOldest();
    bool canRelease() const { return m_chunks.size() > 1; }
    std::size_t bytes() const; ///< in memory

    // The way into an archive, as with FastColumn; a chunk is one stretch.
    Index toArchive() const { return m_archived.handed() * kChunkSamples; }
    std::uint64_t archivableBytes() const;
    std::uint64_t archivedBytes() const { return m_archivedBytes; }
    std::size_t chunkBytes() const { return chunkOf(toArchive()).bytes(); } ///< of the next one
    void handOver(std::vector<Stretch> &to);
    void place(Index first, std::span<const Stretch> where);
    void takeBack() { m_archived.takeBack(); }

private:
    static constexpr std::size_t kBlocks = kChunkSamples / kBlockSamples;
    static constexpr std::size_t kFanOut = 4;
    struct Chunk {
        Nanos start = 0; ///< of its first sample: a search touches one chunk's samples only
        /// From each to the next; 0: the instants are written down, before the values.
        Nanos step = 0;
        bool coded = false; ///< values are places in the table
        bool settled = false; ///< it is full, and the next two are there
        ValueRange all;
        std::array<ValueRange, kBlocks / kFanOut> coarse;
        std::shared_ptr<const std::byte> samples;
        std::shared_ptr<const ValueRange[]> ranges;

        const Nanos *times() const { return reinterpret_cast<const Nanos *>(samples.get()); }
        const std::byte *behindTimes() const
        {
            return samples.get() + (step == 0 ? kChunkSamples * sizeof(Nanos) : 0);
        }
        const double *values() const { return reinterpret_cast<const double *>(behindTimes()); }
        const ValueTable::Code *codes() const
        {
            return reinterpret_cast<const ValueTable::Code *>(behindTimes());
        }
        Nanos timeOf(std::size_t i) const
        {
            return step == 0 ? times()[i] : start + static_cast<Nanos>(i) * step;
        }
        std::size_t bytes() const
        {
            return kChunkSamples
                * ((step == 0 ? sizeof(Nanos) : 0)
                    + (coded ? sizeof(ValueTable::Code) : sizeof(double)));
        }
        std::size_t atOrAfter(Nanos time, std::size_t count, Nanos tolerance) const;
    };
    void addChunk(Nanos start);
    /// First value at or after `time`, not before `low`; or where a block begins, if that is no farther from `time`
    /// than `tolerance`.
    Index edge(Nanos time, Index low, Nanos tolerance) const;
    void measure(std::size_t block); ///< of the last chunk: whole now
    void settle(); ///< the last chunk, which is full, in as few bytes as it takes
    static std::size_t inChunk(Index index)
    {
        return static_cast<std::size_t>(index % kChunkSamples);
    }
    const Chunk &chunkOf(Index index) const
    {
        return m_chunks[static_cast<std::size_t>(index / kChunkSamples - m_released)];
    }
    double valueIn(const Chunk &chunk, std::size_t i) const
    {
        return chunk.coded ? m_table->at(chunk.codes()[i]) : chunk.values()[i];
    }
    ValueRange rangeIn(const Chunk &chunk, std::size_t from, std::size_t to) const;

    std::deque<Chunk> m_chunks;
    std::shared_ptr<ValueTable> m_table; ///< of all chunks that are coded
    // Of the last chunk, for appending.
    Nanos *m_filledTimes = nullptr;
    double *m_filledValues = nullptr;
    ValueRange *m_filledRanges = nullptr;
    std::size_t m_sampleBytes = 0; ///< of all chunks, in memory or not
    std::size_t m_archivedBytes = 0; ///< of those that are not
    ArchivedChunks m_archived;
    Nanos m_lastTime = 0;
    Index m_released = 0; ///< chunks let go
    Index m_end = 0;
    bool m_broken = true;
    std::vector<Run> m_runs;
};

template <class Visit>
void ValueColumn::slices(const Slices &slices, Visit visit) const
{
    if (empty() || slices.empty())
        return;
    constexpr double kRounding = 1.0 / 16;
    const auto tolerance = static_cast<Nanos>(slices.width * kRounding * kNanosPerSecond);
    Index low = edge(toNanos(slices.edge(0)), begin(), tolerance);
    for (std::size_t i = 0; i < slices.count && low < m_end; ++i) {
        const Index high = edge(toNanos(slices.edge(i + 1)), low, tolerance);
        if (high > low)
            visit(i, extremes(low, high));
        low = high;
    }
}

} // namespace capture
