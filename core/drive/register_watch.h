// Reads the watched registers in rounds, where signals that are to be drawn come by themselves (else drive/fcp).
#pragma once

#include "drive/reader.h"
#include "drive/task.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace drive {

template <class P>
class RegisterWatch : public Task<P> {
public:
    explicit RegisterWatch(const typename P::Facts &board)
        : m_board(board)
    {
    }

    void watch(const Watch &watch, TimePoint now);
    void restart(TimePoint now); ///< a new connection: absent registers are asked again, once
    /// No motor is driven and no write is allowed: numbers are read five times a second, what is drawn at the full
    /// rate.
    void setAtRest(bool atRest) { m_atRest = atRest; }
    /// When the next round begins; nothing if there is none.
    std::optional<TimePoint> due() const
    {
        if (m_missing.size() == m_registers.size())
            return std::nullopt;
        return m_atRest && !m_draws ? std::max(m_due, m_begun + kAtRest) : m_due;
    }

    std::optional<typename P::Request> nextRequest(TimePoint now) override
    {
        if (m_reader.finished())
            m_reader.start(begin(now));
        return m_reader.nextRequest();
    }
    void onResponse(const typename P::Answer &response, TimePoint now) override;
    void onNoResponse(std::optional<bool>, TimePoint now) override
    {
        if (m_reader.finished())
            return;
        m_reader.onNoResponse();
        planNext(now);
    }

    const std::vector<Reading> &readings() const { return m_readings; } ///< not taken yet
    std::vector<Reading> takeReadings() { return std::exchange(m_readings, {}); }

protected:
    /// Of rounds like this one, so that the link has time for others: half of it.
    virtual Duration leastPeriod(TimePoint now) const { return 2 * (now - m_begun); }

    const typename P::Facts &m_board;
    TimePoint m_begun; ///< the round

private:
    /// A window takes what it shows for old after 300 ms, and is told up to 80 ms late.
    static constexpr Duration kAtRest = std::chrono::milliseconds(200);

    std::vector<RegisterId> begin(TimePoint now);
    /// A period after this one, or later where the link needs longer.
    void planNext(TimePoint now)
    {
        m_due = std::max(now, m_begun + std::max(m_period, leastPeriod(now)));
    }

    Reader<P> m_reader{m_board};
    std::vector<RegisterId> m_registers; ///< each once
    Duration m_period{};
    std::set<RegisterId> m_missing; ///< of them: reported once and left out from then on
    std::vector<Reading> m_readings;
    TimePoint m_due;
    bool m_atRest = false, m_draws = false;
};

template <class P>
void RegisterWatch<P>::watch(const Watch &watch, TimePoint now)
{
    m_registers.clear();
    for (const RegisterId id : watch.registers)
        if (std::ranges::find(m_registers, id) == m_registers.end())
            m_registers.push_back(id);
    m_period = std::max<Duration>(watch.period, std::chrono::milliseconds(1));
    m_draws = !watch.drawn.empty();
    restart(now);
}

template <class P>
void RegisterWatch<P>::restart(TimePoint now)
{
    m_reader.clear();
    m_missing.clear();
    m_readings.clear();
    m_due = now;
    m_begun = now - kAtRest; // the first round at once
}

/// The registers of a round that begins now, each once; empty: none is due.
template <class P>
std::vector<RegisterId> RegisterWatch<P>::begin(TimePoint now)
{
    std::vector<RegisterId> ids;
    if (now < due().value_or(TimePoint::max()))
        return ids;
    for (const RegisterId id : m_registers)
        if (!m_missing.contains(id))
            ids.push_back(id);
    m_begun = now;
    return ids;
}

template <class P>
void RegisterWatch<P>::onResponse(const typename P::Answer &response, TimePoint now)
{
    if (m_reader.finished())
        return; // the list was changed while this one was asked
    for (Reading &reading : m_reader.onResponse(response, now)) {
        if (reading.status != ReadStatus::Ok)
            m_missing.insert(reading.id);
        m_readings.push_back(std::move(reading));
    }
    planNext(now);
}

} // namespace drive
