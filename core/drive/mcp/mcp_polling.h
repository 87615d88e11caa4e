// Reads the watched registers over and over, in rounds. A round starts at the wished period or as often as the link
// can spare beside stream and commands, whichever is slower.
#pragma once

#include "drive/mcp/mcp_reader.h"
#include "drive/task.h"
#include "drive/watch_round.h"

namespace drive {

class WatchPoll : public Task<McpProtocol> {
public:
    explicit WatchPoll(const McpBoard &board)
        : m_board(board)
    {
    }

    void watch(const Watch &watch, TimePoint now);
    void restart(TimePoint now); ///< a new connection
    /// Bytes a second that the stream takes of the line from the board; the rest is there to be used.
    void setStreamLoad(double bytesPerSecond) { m_streamLoad = bytesPerSecond; }
    std::optional<TimePoint> due() const { return m_round.due(); }

    std::optional<McpRequest> nextRequest(TimePoint now) override;
    void takeResponse(const ByteView &response, TimePoint now) override;
    void takeNoResponse(std::optional<bool> executed, TimePoint now) override;

    std::vector<Reading> takeReadings() { return m_round.takeReadings(); }

private:
    void planNextRound(TimePoint now);

    const McpBoard &m_board;
    RegisterReader m_reader;
    WatchRound m_round;
    std::size_t m_roundBytes = 0; ///< of the answers of the round under way
    double m_streamLoad = 0.0;
};

} // namespace drive
