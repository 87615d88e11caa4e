#include "drive/mcp/mcp_polling.h"

#include <algorithm>

namespace drive {

namespace {

// Of the line time that the stream leaves, polling takes no more than this part: commands and keep-alive need some,
// and a line that is full to the brim makes the board drop samples.
constexpr double kSharePolling = 0.5;
constexpr std::size_t kPacketOverhead = 5; // header and status of an answer
constexpr double kLeastBytesPerSecond =
    100.0; // so that even on a full line values get older, but never dead

} // namespace

void WatchPoll::watch(const Watch &watch, TimePoint now)
{
    m_reader.clear();
    m_round.watch(watch, now);
}

void WatchPoll::restart(TimePoint now)
{
    m_reader.clear();
    m_round.restart(now);
}

std::optional<McpRequest> WatchPoll::nextRequest(TimePoint now)
{
    if (m_reader.finished()) {
        const auto ids = m_round.begin(now);
        if (ids.empty())
            return std::nullopt;
        m_reader.start(ids, m_board);
        m_roundBytes = 0;
    }
    return m_reader.nextRequest(m_board);
}

void WatchPoll::takeResponse(const ByteView &response, TimePoint now)
{
    m_roundBytes += response.size() + kPacketOverhead;
    for (Reading &reading : m_reader.takeResponse(response, m_board, now))
        m_round.take(std::move(reading));
    planNextRound(now);
}

void WatchPoll::takeNoResponse(std::optional<bool>, TimePoint now)
{
    m_reader.takeNoResponse();
    planNextRound(now);
}

void WatchPoll::planNextRound(TimePoint now)
{
    const double spare = m_board.streaming.linkBytesPerSecond - m_streamLoad;
    const double rate = std::max(spare * kSharePolling, kLeastBytesPerSecond);
    m_round.planNext(fromSeconds(static_cast<double>(m_roundBytes) / rate), now);
}

} // namespace drive
