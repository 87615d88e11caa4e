// Polls what a person must always be able to trust: the status word, the measured velocity, and the latest error where
// there is a fault. Slow while nothing happens, fast while a start or a stop is under way.
#pragma once

#include "drive/mcb/mcb_reader.h"
#include "drive/task.h"

namespace drive {

class McbVitals : public Task<McbProtocol> {
public:
    static constexpr Duration kPeriod = std::chrono::milliseconds(100);
    static constexpr Duration kFastPeriod = std::chrono::milliseconds(20);
    static constexpr Duration kHurry = std::chrono::milliseconds(500);

    explicit McbVitals(const McbBoard &board)
        : m_board(board)
    {
    }

    void restart(TimePoint now); ///< a new connection: nothing known counts any more
    void hurry(TimePoint now); ///< something was commanded: read at once and fast for a while
    std::optional<TimePoint> due() const { return m_due; }

    std::optional<McbRequest> nextRequest(TimePoint now) override;
    void takeResponse(const McbAnswer &answer, TimePoint now) override;
    void takeNoResponse(std::optional<bool> executed, TimePoint now) override;

    std::vector<MotorStatus> takeStatuses() { return std::exchange(m_news, {}); }
    TimePoint askedAt() const { return m_askedAt; } ///< evidence is never older than this

private:
    void afterAnswer(TimePoint now);
    void publish(TimePoint now);

    const McbBoard &m_board;
    McbReader m_reader;
    std::map<RegisterId, Value> m_round;
    std::vector<MotorStatus> m_news;
    std::optional<TimePoint> m_due;
    TimePoint m_fastUntil, m_askedAt, m_roundAsked;
    bool m_errorAsked = false, m_moving = false;
};

} // namespace drive
