// What a board of MCP says, taken apart by the text of the protocol alone: the values it gives when it is asked, and
// the samples it sends by itself. It sees the line at the board's end, so that no packet is ever in pieces; what was
// lost on the way is not taken. Values and samples of the last kKept only. Lengths and numbers: mcp-aspep, sections
// 2.1, 4.5 and 6.
#pragma once

#include "base/bytes.h"
#include "support/wire/given_values.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

namespace judge {

/// The least and the greatest of some numbers; none: empty.
struct Extremes {
    double least = 1.0, greatest = 0.0;

    bool empty() const { return least > greatest; }
    void include(double value)
    {
        const bool first = empty();
        least = first ? value : std::min(least, value);
        greatest = first ? value : std::max(greatest, value);
    }
    void include(const Extremes &more)
    {
        if (more.empty())
            return;
        include(more.least);
        include(more.greatest);
    }
};

class McpBoard {
public:
    static constexpr Duration kKept = GivenValues::kKept;

    struct Sample {
        std::int64_t tick = 0; ///< control periods
        std::int16_t digits = 0;
    };

    void reset(); ///< the board began anew
    void forgetSamples() { m_tracks.clear(); }
    /// What goes to the board. @param arrives  false: lost on the way
    void asks(ByteView bytes, bool arrives);
    /// @param arrives  false: lost on the way
    void says(ByteView bytes, TimePoint at, bool arrives);

    const GivenValues &given() const { return m_given; }
    const std::deque<Sample> &samplesOf(std::uint16_t id) const;
    /// When the newest samples of it arrived; empty: none did.
    std::optional<TimePoint> sampledAt(std::uint16_t id) const;
    std::optional<std::int64_t> newestTick(std::uint16_t id) const;
    std::optional<std::int64_t> oldestTick(std::uint16_t id) const; ///< that is kept
    /// The samples of [from, to) ticks.
    Extremes extremes(std::uint16_t id, std::int64_t from, std::int64_t to) const;
    /// Of those that arrived since, or between two times.
    Extremes since(std::uint16_t id, TimePoint from) const
    {
        return between(id, from, TimePoint::max());
    }
    Extremes between(std::uint16_t id, TimePoint from, TimePoint to) const;
    /// When a packet of samples was lost on the way, and the tick at which it began.
    const std::deque<std::pair<TimePoint, std::int64_t>> &lost() const { return m_lost; }
    std::uint64_t samples() const { return m_samples; } ///< that arrived, of all registers

private:
    struct Config {
        unsigned fastStep = 1, slowEvery = 255;
        std::vector<std::uint16_t> fast, slow;
    };
    struct Track {
        std::deque<Sample> samples;
        std::deque<std::pair<TimePoint, std::size_t>> packets; ///< when so many came
    };

    void request(ByteView payload);
    void setUp(ByteView raw);
    void answer(ByteView payload, TimePoint at);
    void packet(ByteView payload, TimePoint at);
    void keep(std::uint16_t id, std::int64_t tick, std::int16_t digits, TimePoint at);
    void forgetOld(TimePoint now);

    Bytes m_asked, m_said; ///< of packets that are not whole
    std::size_t m_askedWanted = 0, m_saidWanted = 0; ///< of the payload
    unsigned m_saidType = 0;
    bool m_askedArrives = true, m_saidArrives = true; ///< of the packet that is not whole
    std::vector<std::uint16_t> m_due; ///< registers that the next answer is about
    std::map<unsigned, Config> m_configs; ///< by mark
    GivenValues m_given;
    std::map<std::uint16_t, Track> m_tracks;
    std::int64_t m_lastTick = -1;
    std::uint64_t m_samples = 0;
    std::deque<std::pair<TimePoint, std::int64_t>> m_lost;
};

} // namespace judge
