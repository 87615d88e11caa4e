// The user's read wish: what cannot be asked is told at once, the rest is asked register by register.
#pragma once

#include "drive/reader.h"
#include "drive/task.h"

namespace drive {

template <class P>
class ReadTask : public WishTask<P> {
public:
    ReadTask(WishId id, const Read &read, const typename P::Facts &board)
        : WishTask<P>(id, Permission::Always)
        , m_board(board)
        , m_ids(read.registers)
    {
    }
    bool onlyReads() const override { return true; }
    std::vector<Reading> takeReadings() override { return std::exchange(m_readings, {}); }

    std::optional<typename P::Request> nextRequest(TimePoint now) override
    {
        if (!std::exchange(m_started, true)) {
            std::vector<RegisterId> ids;
            for (const RegisterId id : m_ids) {
                if (const auto status = P::Reads::refuse(m_board, id))
                    m_readings.push_back({id, *status, {}, now});
                else
                    ids.push_back(id);
            }
            m_reader.start(ids);
            endIfRead();
        }
        return m_reader.nextRequest();
    }
    void onResponse(const typename P::Answer &response, TimePoint now) override
    {
        for (Reading &reading : m_reader.onResponse(response, now))
            m_readings.push_back(std::move(reading));
        endIfRead();
    }
    void onNoResponse(std::optional<bool>, TimePoint) override
    {
        m_reader.onNoResponse();
        endIfRead();
    }

private:
    void endIfRead()
    {
        if (m_reader.finished() && !this->finished())
            this->end(m_reader.gaveUp() ? Outcome::Unknown : Outcome::Ok,
                m_reader.gaveUp() ? kNoAnswer : "");
    }

    const typename P::Facts &m_board;
    std::vector<RegisterId> m_ids;
    Reader<P> m_reader{m_board};
    std::vector<Reading> m_readings;
    bool m_started = false;
};

} // namespace drive
