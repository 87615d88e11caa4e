#include "drive/mcb/mcb_watch.h"

#include "drive/mcb/mcb_catalog.h"

#include <algorithm>

namespace drive {

void McbWatch::watch(const Watch &watch, TimePoint now)
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

void McbWatch::restart(TimePoint now)
{
    m_reader.clear();
    m_missing.clear();
    m_readings.clear();
    m_active = !m_watch.registers.empty();
    m_due = now;
}

std::optional<Bytes> McbWatch::nextRequest(TimePoint now)
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
        m_reader.start(ids);
        m_roundStart = now;
    }
    return m_reader.nextRequest();
}

void McbWatch::takeResponse(ByteView response, TimePoint now)
{
    Reading reading = m_reader.takeResponse(response, m_board, now);
    if (reading.status != ReadStatus::Ok)
        m_missing.insert(reading.id);
    m_readings.push_back(std::move(reading));
    planNextRound(now);
}

void McbWatch::takeNoResponse(std::optional<bool>, TimePoint now)
{
    m_reader.takeNoResponse();
    planNextRound(now);
}

/// Half of the time is for others.
void McbWatch::planNextRound(TimePoint now)
{
    m_due = std::max({now, m_roundStart + m_watch.period, now + (now - m_roundStart)});
}

std::optional<Bytes> McbReadTask::nextRequest(TimePoint now)
{
    if (finished())
        return std::nullopt;
    if (!std::exchange(m_started, true)) {
        std::vector<RegisterId> ids;
        for (const RegisterId id : m_ids) {
            if (m_board.infoOf(mcbAddressOf(id)) == nullptr || m_board.readable(mcbAddressOf(id)))
                ids.push_back(id);
            else
                m_readings.push_back({id, ReadStatus::NotSupported, {}, now});
        }
        m_reader.start(ids);
        finish();
    }
    return m_reader.nextRequest();
}

void McbReadTask::takeResponse(ByteView response, TimePoint now)
{
    m_readings.push_back(m_reader.takeResponse(response, m_board, now));
    finish();
}

void McbReadTask::takeNoResponse(std::optional<bool>, TimePoint)
{
    m_reader.takeNoResponse();
    finish();
}

void McbReadTask::finish()
{
    if (m_reader.finished())
        end(m_reader.gaveUp() ? Outcome::Unknown : Outcome::Ok,
            m_reader.gaveUp() ? "no answer" : "");
}

} // namespace drive
