#include "drive/watch_round.h"

#include <algorithm>

namespace drive {

void WatchRound::watch(const Watch &watch, TimePoint now)
{
    m_registers.clear();
    for (const RegisterId id : watch.registers)
        if (std::find(m_registers.begin(), m_registers.end(), id) == m_registers.end())
            m_registers.push_back(id);
    m_period = std::max<Duration>(watch.period, std::chrono::milliseconds(1));
    restart(now);
}

void WatchRound::restart(TimePoint now)
{
    m_missing.clear();
    m_readings.clear();
    m_active = !m_registers.empty();
    m_due = now;
}

std::vector<RegisterId> WatchRound::begin(TimePoint now)
{
    std::vector<RegisterId> ids;
    if (!m_active || now < m_due)
        return ids;
    for (const RegisterId id : m_registers)
        if (!m_missing.contains(id))
            ids.push_back(id);
    m_active = !ids.empty();
    m_begun = now;
    return ids;
}

void WatchRound::take(Reading reading)
{
    if (reading.status != ReadStatus::Ok)
        m_missing.insert(reading.id);
    m_readings.push_back(std::move(reading));
}

void WatchRound::planNext(Duration atLeast, TimePoint now)
{
    m_due = std::max(now, m_begun + std::max(m_period, atLeast));
}

} // namespace drive
