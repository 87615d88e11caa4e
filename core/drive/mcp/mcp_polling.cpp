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
    m_watch = watch;
    std::vector<RegisterId> unique;
    for (const RegisterId id : m_watch.registers)
        if (std::find(unique.begin(), unique.end(), id) == unique.end())
            unique.push_back(id);
    m_watch.registers = std::move(unique);
    m_watch.period = std::max<Duration>(m_watch.period, std::chrono::milliseconds(1));
    restart(now);
}

void WatchPoll::restart(TimePoint now)
{
    m_reader.clear();
    m_missing.clear();
    m_readings.clear();
    m_active = !m_watch.registers.empty();
    m_due = now;
}

std::optional<TimePoint> WatchPoll::due() const
{
    return m_active ? std::optional<TimePoint>(m_due) : std::nullopt;
}

std::optional<Bytes> WatchPoll::nextRequest(TimePoint now)
{
    if (m_reader.finished()) {
        if (!m_active || now < m_due)
            return std::nullopt;
        std::vector<RegisterId> ids;
        for (const RegisterId id : m_watch.registers)
            if (!m_missing.contains(id))
                ids.push_back(id);
        if (ids.empty()) {
            m_active = false;
            return std::nullopt;
        }
        m_reader.start(ids, m_board);
        m_roundStart = now;
        m_roundBytes = 0;
    }
    return m_reader.nextRequest(m_board);
}

void WatchPoll::takeResponse(ByteView response, TimePoint now)
{
    m_roundBytes += response.size() + kPacketOverhead;
    for (Reading &reading : m_reader.takeResponse(response, m_board, now)) {
        if (reading.status != ReadStatus::Ok)
            m_missing.insert(reading.id);
        m_readings.push_back(std::move(reading));
    }
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
    const Duration linkTime = fromSeconds(static_cast<double>(m_roundBytes) / rate);
    m_due = std::max(now, m_roundStart + std::max(m_watch.period, linkTime));
}

} // namespace drive
