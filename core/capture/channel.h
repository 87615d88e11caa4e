// One channel of a capture: what it is and its column, with the questions that do not depend on how
// it is stored. Copying makes a snapshot (see FastColumn).
#pragma once

#include "capture/value_column.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace capture {

/// Names a channel for as long as the capture lives.
using ChannelId = std::uint32_t;

/// Channels that no board sent (computed, or from a file) have registers from here on: no board has such ones.
inline constexpr catalog::RegisterId kFirstOwnRegister = 0xE0000000;

struct ChannelInfo {
    ChannelId id = 0;
    catalog::RegisterId registerId = 0;
    std::string name;
    std::string unit;
    double factor = 1.0; ///< shown = (stored + offset) * factor
    double offset = 0.0;
    enum class Kind : std::uint8_t {
        Fast, ///< recorded by the board at its control rate
        Slow, ///< recorded by the board, less often
        Polled, ///< asked for by us, whenever the link had time
    } kind = Kind::Fast;
    bool real = false; ///< the board sends a 32-bit float, whose last digit says nothing

    bool isBoards() const { return registerId < kFirstOwnRegister; }
    /// What one digit is worth; 0 if there is none to speak of: the values are no integers, or came scaled already.
    double digit() const { return kind == Kind::Polled || real || !isBoards() ? 0.0 : factor; }
};

/// Seconds on the session's axis, half-open; each end stands for its nearest nanosecond.
struct TimeSpan {
    double from = 0.0;
    double to = 0.0;
};

/// A sample for drawing: in seconds and in the channel's unit.
struct Sample {
    double time = 0.0;
    double value = 0.0;
    /// The value is not known to be true after this: the next sample, or where the gap starts.
    double holdUntil = 0.0;
    bool first = false; ///< nothing is known right before it
};

class Channel {
public:
    using Column = std::variant<FastColumn, ValueColumn>;

    /// @param memory  for the samples of a fast channel; nullptr: its own
    explicit Channel(ChannelInfo info, std::shared_ptr<SampleMemory> memory = nullptr);

    /// The same samples under another id: no copy, a pointer a chunk.
    Channel(const Channel &other, ChannelId id)
        : Channel(other)
    {
        m_info.id = id;
    }

    const ChannelInfo &info() const { return m_info; }
    const FastColumn *fast() const { return std::get_if<FastColumn>(&m_column); }
    FastColumn *fast() { return std::get_if<FastColumn>(&m_column); }
    const ValueColumn *values() const { return std::get_if<ValueColumn>(&m_column); }
    ValueColumn *values() { return std::get_if<ValueColumn>(&m_column); }
    const Column &column() const { return m_column; }

    Index begin() const;
    Index end() const;
    std::uint64_t size() const { return end() - begin(); }
    bool empty() const { return begin() == end(); }
    Nanos timeOf(Index index) const;
    double at(Index index) const; ///< in the channel's unit
    Index atOrAfter(Nanos time) const;
    std::size_t pieceOf(Index index) const; ///< the same for samples without a gap between them
    Nanos holdUntil(Index index) const; ///< until when that sample's value is known to be true

    /// [first sample, end of the last one's step); a polled value ends where it begins. nullopt if there is no sample.
    std::optional<TimeSpan> timeSpan() const;

    /// Extremes of the samples in [from, to); exact. empty() if there are none.
    MinMax extremes(double from, double to) const;

    /// Extremes of slices, one a pixel column; see FastColumn::slices.
    std::vector<MinMax> columns(const Slices &slices) const;
    std::vector<MinMax> columns(double from, double to, std::size_t count) const
    {
        return columns(Slices::of(from, to, count));
    }

    /// The newest sample at or before `time`, while it holds; nullopt in gaps.
    std::optional<double> valueAt(double time) const { return valueAt(toNanos(time)); }
    std::optional<double> valueAt(Nanos time) const;

    /// The samples in [from, to), and the one before it if it still holds at `from`; the oldest
    /// `limit` of them.
    std::vector<Sample> samples(double from, double to, std::size_t limit) const;
    std::uint64_t countIn(double from, double to) const;

    /// Where nothing is known between two samples that touch [from, to), if wider than `least`
    /// seconds; also where the oldest samples were let go.
    std::vector<TimeSpan> gaps(double from, double to, double least) const;
    /// Has the same gaps as that one, as signals of one stream do. Cost: two of them are compared.
    bool sharesGapsWith(const Channel &other) const;

    double toShown(double stored) const { return (stored + m_info.offset) * m_info.factor; }
    std::size_t bytes() const; ///< in memory
    std::uint64_t archivedBytes() const; ///< in an archive
    bool canRelease() const;
    void releaseOldest(); ///< from then on gaps() tells where samples were
    Nanos oldest() const { return timeOf(begin()); } ///< not on an empty channel

    // The way of the samples into an archive, a chunk at a time; see FastColumn.
    std::uint64_t archivableBytes() const;
    std::size_t chunkBytes() const; ///< of the next chunk in an archive
    Index toArchive() const; ///< first sample of the chunk that is next
    /// Returns how many stretches it appended. Only if archivableBytes() is not 0.
    std::size_t handOver(std::vector<Stretch> &to);
    void place(Index first, std::span<const Stretch> where);
    void takeBack();

private:
    /// Of codes or values; empty() if there are none.
    template <class Range>
    MinMax shown(const Range &range) const;

    ChannelInfo m_info;
    Column m_column;
    std::optional<Nanos> m_released; ///< where the first sample was that is not kept any more
};

} // namespace capture
