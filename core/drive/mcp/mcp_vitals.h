// Polls what a person must always be able to trust: state, faults and speed of every motor. Runs on its own schedule,
// slow while nothing happens, fast while a start or a stop is under way.
#pragma once

#include "drive/mcp/mcp_reader.h"
#include "drive/task.h"

#include <map>
#include <set>

namespace drive {

class VitalPoll : public Task<McpProtocol> {
public:
    static constexpr Duration kPeriod = std::chrono::milliseconds(100);
    static constexpr Duration kFastPeriod = std::chrono::milliseconds(20);
    static constexpr Duration kHurry =
        std::chrono::milliseconds(500); ///< how long hurry() keeps it fast

    explicit VitalPoll(const McpBoard &board)
        : m_board(board)
    {
    }

    void restart(TimePoint now); ///< a new connection: nothing known counts any more
    void hurry(TimePoint now); ///< something was commanded: read at once and fast for a while
    std::optional<TimePoint> due() const { return m_due; }
    /// Every motor has been read at least once since restart().
    bool complete() const { return m_complete; }

    std::optional<McpRequest> nextRequest(TimePoint now) override;
    void takeResponse(const ByteView &response, TimePoint now) override;
    void takeNoResponse(std::optional<bool> executed, TimePoint now) override;

    /// What was read since the last call.
    std::vector<MotorStatus> takeStatuses() { return std::exchange(m_news, {}); }
    /// When the first request behind the newest statuses was handed out: evidence is never older than this.
    TimePoint askedAt() const { return m_askedAt; }

private:
    std::vector<RegisterId> idsToRead() const;
    void publish(TimePoint now);
    bool somethingUnderWay() const;

    const McpBoard &m_board;
    RegisterReader m_reader;
    std::map<RegisterId, Value> m_round; ///< what the round under way has read
    std::set<RegisterId> m_missing; ///< answered UNKNOWN_REG: not asked again
    std::map<int, MotorState> m_states;
    std::vector<MotorStatus> m_news;
    std::optional<TimePoint> m_due;
    TimePoint m_fastUntil;
    TimePoint m_askedAt, m_roundAsked;
    bool m_complete = false;
};

/// The neutral state behind a STATUS number.
MotorState motorStateOf(std::int64_t status);
/// The states of a run in their order; those before the start, and those that are rare, share a step.
std::vector<StateStep> stateSteps();

} // namespace drive
