// Batcher: gathers a drive's events into batches that a slow receiver can bear. Pure values on
// given time; it never emits anything itself.
//
// While the receiver keeps up, every event is handed on as it came. While two batches are
// unacknowledged, what waits is thinned: the newest status of each motor and the newest counters
// stay. Readings and samples are drawn and stay up to a bound; beyond it the newest reading of each
// register stays, and samples are dropped, counted, and shown as lost ticks of the next block. What
// happened once (ends of wishes, stops, identities) always stays.
#pragma once

#include "drive/event.h"

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

namespace session {

/// What a session tells at one go, in order. A complete value that may cross threads.
struct Batch {
    std::vector<drive::Event> events;
    /// Samples since the session began that only the display did not get.
    std::uint64_t droppedForDisplay = 0;
};
using BatchPtr = std::shared_ptr<const Batch>;

class Batcher {
public:
    struct Config {
        /// Time between two batches; a batch that was late by a quarter of it or less does not delay the next.
        Duration period = std::chrono::milliseconds(16);
        Duration calmPeriod = std::chrono::milliseconds(66); ///< while nothing moves
        int maxUnacknowledged = 2;
        /// Sample values, about 20 s of a full 1.8 Mbaud link.
        std::size_t maxWaitingValues = 2'000'000;
        std::size_t maxWaitingReadings = 20'000; ///< of registers, about 20 s of the fastest link
        std::size_t maxLinkChanges = 8; ///< link states kept while waiting; the newest ones
    };

    Batcher() = default;
    explicit Batcher(Config config)
        : m_config(config)
    {
    }

    void add(drive::Event event);
    void acknowledge() { m_unacknowledged = std::max(0, m_unacknowledged - 1); }
    void setCalm(bool calm) { m_calm = calm; } ///< nothing moves; from the next batch on

    /// When take() will give a batch; empty while there is nothing to tell or the receiver is
    /// behind.
    std::optional<TimePoint> due() const;
    /// The next batch, or nullptr if it is not due.
    BatchPtr take(TimePoint now);
    /// All that waits, whatever the pace: the last words before a port is closed. nullptr if
    /// nothing waits.
    BatchPtr takeAll() { return m_waiting.empty() ? nullptr : hand(); }

private:
    struct Stream {
        capture::Tick step = 1;
        capture::Tick end = 0; ///< tick after the last block handed on
        bool dropping = false;
    };

    bool behind() const { return m_unacknowledged >= m_config.maxUnacknowledged; }
    void addBlock(capture::SampleBlock block);
    void addReadings(drive::RegistersRead event);
    /// Readings of the same registers go that came before, so that the newest stand last, behind
    /// whatever else was told meanwhile.
    void dropOlderThan(const drive::RegistersRead &event);
    template <class Same>
    void replace(drive::Event event, Same same);
    BatchPtr hand();

    Config m_config{};
    std::vector<drive::Event> m_waiting;
    std::size_t m_waitingValues = 0;
    std::size_t m_waitingReadings = 0;
    std::uint64_t m_dropped = 0;
    int m_unacknowledged = 0;
    bool m_calm = false;
    TimePoint m_notBefore{};
    std::unordered_map<capture::StreamId, Stream> m_streams;
};

} // namespace session
