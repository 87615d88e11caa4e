// Capture: everything recorded, as columns. Append-only, in one thread (the GUI's or the command
// line's); other threads read snapshots. It draws, scales and writes nothing.
//
// Call order: begin(layout) whenever a stream takes effect, append(block) for its blocks;
// appendPolled() at any time.
#pragma once

#include "capture/channel.h"

#include <memory>
#include <set>
#include <span>
#include <string_view>

namespace capture {

/// Some channels as they were at one moment; immutable, may be read in any thread. Costs a pointer
/// a chunk.
using Snapshot = std::shared_ptr<const std::vector<Channel>>;

class Capture {
public:
    struct Config {
        /// Of memory. From three quarters of it on the oldest samples go to the archive; what does not fit is
        /// released, the oldest first, a chunk at a time.
        std::size_t maxBytes = 1'500'000'000;
        /// Seconds that a polled value counts as true if no newer one comes.
        double polledHold = 2.0;
        /// Of the fast samples; none: the computer's own.
        std::shared_ptr<SampleMemory> memory = nullptr;
        /// For what there is no memory for; none: memory only.
        std::shared_ptr<SampleArchive> archive = nullptr;
        /// append() waits for a slow archive and releases nothing for it: reading a file can wait,
        /// a live board cannot
        bool patient = false;
    };
    /// Blocks and values that were not taken, by reason; all stay 0 with a drive that keeps its
    /// word.
    struct Refused {
        std::uint64_t otherStream = 0; ///< block of a stream that is not the one in effect
        std::uint64_t malformed = 0; ///< sizes that do not fit the layout
        std::uint64_t backwards = 0; ///< not later than what is there
        std::uint64_t notFinite = 0; ///< polled value that is no number
    };

    Capture();
    explicit Capture(Config config);

    /// A stream takes effect; an empty layout ends the one before. A register that was streamed
    /// before with the same kind, unit and scale continues its channel behind a gap. If the new
    /// time axis would run backwards (a board's clock restarted) it is moved to follow the old one.
    void begin(const StreamLayout &layout);

    /// Appends one packet's samples to the channels of begin(). A loss before the block becomes a
    /// gap.
    void append(const SampleBlock &block);

    /// Why a value was asked for: as a signal, or for a table of the window (a recording holds such ones, too).
    enum class Asked : std::uint8_t { AsSignal, Aside };
    /// Appends a value that was asked for at `seconds` on the session's axis; makes its channel if
    /// needed.
    void appendPolled(catalog::RegisterId id, std::string_view name, std::string_view unit,
        double seconds, double value, Asked why = Asked::AsSignal);

    /// This register is not asked for any more: its last value is not held any longer.
    void endPolled(catalog::RegisterId id);
    /// The next value of it begins a channel of its own: its numbers do not follow those before.
    void endPolledForGood(catalog::RegisterId id);

    /// A channel of values that came from a file or were computed; kind Slow.
    /// @param id  it is found by, at least kFirstOwnRegister; 0: one that is not known
    ChannelId addImported(std::string name, std::string unit, catalog::RegisterId id = 0);
    /// Appends a value to it, or several without a gap between them. Instants must rise.
    void appendImported(ChannelId id, Nanos time, double value, Nanos holdUntil)
    {
        appendImported(id, std::span(&time, 1), std::span(&value, 1), holdUntil);
    }
    void appendImported(ChannelId id, std::span<const Nanos> times, std::span<const double> values,
        Nanos holdUntil);
    /// Nothing is known between its last value and the next one.
    void breakImported(ChannelId id);
    /// Lets go of its oldest values, a chunk at a time, until there are at most so many.
    void keepNewest(ChannelId id, std::uint64_t most);
    /// Forgets a channel of addImported(); nothing happens to others.
    void removeImported(ChannelId id);

    /// Forgets all samples and channels; ids are not used again. A stream in effect goes on with
    /// new channels.
    void clear();

    /// Forgets all samples and channels and takes those of another capture, under ids of its own. A stream in effect
    /// has ended; begin() comes before the next block.
    void adopt(Capture other);

    std::vector<ChannelInfo> channels() const; ///< oldest first
    /// Nullptr if there is none; valid until the next change.
    const Channel *channel(ChannelId id) const;
    std::optional<ChannelInfo> info(ChannelId id) const;
    /// The channel of a register that was streamed or asked for as a signal last; one that holds samples goes before
    /// one that holds none, and one with values read aside comes last.
    std::optional<ChannelId> find(catalog::RegisterId id) const;
    std::optional<ChannelId> find(catalog::RegisterId id, ChannelInfo::Kind kind) const;
    /// Channels of the stream in effect: fast, then slow, in layout order.
    std::vector<ChannelId> streaming() const;

    std::uint64_t size(ChannelId id) const; ///< samples kept
    std::optional<TimeSpan> timeSpan() const; ///< of all channels; nullopt if nothing is recorded
    std::optional<TimeSpan> timeSpan(ChannelId id) const;

    // The questions of Channel, for an id; an unknown id is an empty channel.
    std::vector<MinMax> columns(ChannelId id, double from, double to, std::size_t count) const;
    MinMax extremes(ChannelId id, double from, double to) const;
    std::optional<double> valueAt(ChannelId id, double time) const;
    std::optional<double> lastValue(ChannelId id) const;

    /// For readers that take their time, such as an export; unknown ids are left out.
    Snapshot snapshot(std::span<const ChannelId> ids) const;

    std::uint64_t revision() const { return m_revision; } ///< grows with every change
    std::size_t bytes() const; ///< of the columns, in memory
    std::uint64_t archivedBytes() const; ///< of the columns, in the archive
    /// Bytes that may be kept in the archive: its budget, or less if it refused some; 0 without one.
    std::uint64_t archiveRoom() const;
    /// An archive that refused gets samples again, up to its budget; for when the user made room.
    void tryArchiveAgain() { m_archiveMost = kNoLimit; }
    const Refused &refused() const { return m_refused; }
    /// Samples that were let go since the last clear(), because there is no room for more.
    std::uint64_t released() const { return m_released; }
    std::size_t maxBytes() const { return m_config.maxBytes; }
    /// True if times are not those of the session: a board's clock restarted, and what followed was moved behind.
    bool clockMoved() const { return m_shift != 0; }

private:
    struct Entry {
        std::unique_ptr<Channel> channel; ///< pointers stay valid while others are added
        std::uint64_t touched = 0; ///< 0: only by values that were read aside
    };
    Entry &entryOf(ChannelId id); ///< which is there

    Channel *channelFor(
        const StreamSignal &signal, ChannelInfo::Kind kind, std::span<Channel *const> taken);
    ChannelId add(ChannelInfo info);
    void makeStreamChannels();
    Channel *mutableChannel(ChannelId id) { return const_cast<Channel *>(channel(id)); }
    void appendFast(const SampleBlock &block);
    void appendSlow(const SampleBlock &block);
    bool follows(const SampleBlock &block);
    void breakStream();
    void keepWithinLimit();
    bool releaseOldest();
    void fillArchive();
    bool handOver();
    void adoptArchived();
    void forgetDeposits();

    static constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();
    /// On its way to the archive.
    struct Sent {
        struct Chunk {
            ChannelId channel = 0;
            Index first = 0;
            std::size_t stretches = 0;
        };
        std::shared_ptr<const Deposit> deposit;
        std::vector<Chunk> chunks;
        std::size_t bytes = 0;
    };

    Config m_config;
    std::vector<Entry> m_entries;
    ChannelId m_nextId = 1;
    StreamLayout m_layout;
    TickBase m_layoutBase; ///< as the layout has it
    TickBase m_base; ///< and shifted behind what was there
    Nanos m_shift = 0; ///< added to every origin, so that time never runs backwards
    bool m_fresh = false; ///< no block since begin()
    /// Of the layout; the entries own them, and keep what a board streams.
    std::vector<Channel *> m_fast;
    std::vector<Channel *> m_slow;
    Nanos m_streamEnd = std::numeric_limits<Nanos>::min(); ///< where the streamed samples end
    /// Of the groups of the block being appended; kept, as memory is.
    std::vector<Nanos> m_slowTimes;
    std::vector<double> m_slowValues; ///< of one signal at those times; kept, too
    std::uint64_t m_revision = 0;
    std::uint64_t m_sinceCheck = 0;
    std::uint64_t m_released = 0;
    std::deque<Sent> m_sent; ///< in the order in which they will be settled
    std::size_t m_sentBytes = 0;
    std::uint64_t m_archiveMost = kNoLimit; ///< less once the archive has refused
    Refused m_refused;
    std::set<catalog::RegisterId> m_polledAnew; ///< ended for good, not begun again
};

/// A stretch of a capture as a capture of its own, which stays when the other lets go of its samples: those in [from,
/// to) of all channels that have any there, in their order. They have their names and units, not their registers; gaps
/// stay gaps. Cost: a search and 24 bytes a sample.
Capture excerptOf(const Capture &capture, Nanos from, Nanos to);

} // namespace capture
