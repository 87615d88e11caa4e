#include "drive/mcp/mcp_watch.h"

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

void McpWatch::onResponse(const ByteView &response, TimePoint now)
{
    if (std::exchange(m_counted, m_begun) != m_begun)
        m_roundBytes = 0;
    m_roundBytes += response.size() + kPacketOverhead;
    RegisterWatch::onResponse(response, now);
}

Duration McpWatch::leastPeriod(TimePoint) const
{
    const std::size_t bytes = m_counted == m_begun ? m_roundBytes : 0;
    const double spare = m_board.streaming.linkBytesPerSecond - m_streamLoad;
    return fromSeconds(
        static_cast<double>(bytes) / std::max(spare * kSharePolling, kLeastBytesPerSecond));
}

} // namespace drive
