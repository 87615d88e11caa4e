// Reads the watched registers in rounds, where signals that are to be drawn come by themselves (else drive/fcp).
#pragma once

#include "drive/reader.h"
#include "drive/task.h"
#include "drive/watch_round.h"

namespace drive {

template <class P>
class RegisterWatch : public Task<P> {
public:
    explicit RegisterWatch(const typename P::Facts &board)
        : m_board(board)
    {
    }

    void watch(const Watch &watch, TimePoint now)
    {
        m_reader.clear();
        m_round.watch(watch, now);
    }
    void restart(TimePoint now) ///< a new connection
    {
        m_reader.clear();
        m_round.restart(now);
    }
    std::optional<TimePoint> due() const { return m_round.due(); }

    std::optional<typename P::Request> nextRequest(TimePoint now) override
    {
        if (m_reader.finished())
            m_reader.start(m_round.begin(now));
        return m_reader.nextRequest();
    }
    void onResponse(const typename P::Answer &response, TimePoint now) override
    {
        if (m_reader.finished())
            return; // the list was changed while this one was asked
        for (Reading &reading : m_reader.onResponse(response, now))
            m_round.take(std::move(reading));
        m_round.planNext(leastPeriod(now), now);
    }
    void onNoResponse(std::optional<bool>, TimePoint now) override
    {
        if (m_reader.finished())
            return;
        m_reader.onNoResponse();
        m_round.planNext(leastPeriod(now), now);
    }

    std::vector<Reading> takeReadings() { return m_round.takeReadings(); }

protected:
    /// Of rounds like this one, so that the link has time for others: half of it.
    virtual Duration leastPeriod(TimePoint now) const { return 2 * (now - m_round.begun()); }

    const typename P::Facts &m_board;
    WatchRound m_round;

private:
    Reader<P> m_reader{m_board};
};

} // namespace drive
