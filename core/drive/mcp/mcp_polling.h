// Reads the watched registers over and over, in rounds. A round starts at the wished period or as often as the link
// can spare beside stream and commands, whichever is slower. What the build does not have is reported once and left
// out from then on.
#pragma once

#include "drive/mcp/mcp_reader.h"
#include "drive/task.h"

#include <set>

namespace drive {

class WatchPoll : public Task {
public:
    explicit WatchPoll(const McpBoard &board)
        : m_board(board)
    {
    }

    void watch(const Watch &watch, TimePoint now);
    void restart(TimePoint now); ///< a new connection: absent registers are asked again, once
    /// Bytes a second that the stream takes of the line from the board; the rest is there to be used.
    void setStreamLoad(double bytesPerSecond) { m_streamLoad = bytesPerSecond; }
    std::optional<TimePoint> due() const;

    std::optional<Bytes> nextRequest(TimePoint now) override;
    void takeResponse(ByteView response, TimePoint now) override;
    void takeNoResponse(std::optional<bool> executed, TimePoint now) override;

    std::vector<Reading> takeReadings() { return std::exchange(m_readings, {}); }

private:
    void planNextRound(TimePoint now);

    const McpBoard &m_board;
    RegisterReader m_reader;
    Watch m_watch;
    std::set<RegisterId> m_missing;
    std::vector<Reading> m_readings;
    TimePoint m_roundStart, m_due;
    std::size_t m_roundBytes = 0; ///< of the answers of the round under way
    double m_streamLoad = 0.0;
    bool m_active = false;
};

} // namespace drive
