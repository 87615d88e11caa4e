// What is read over and over on a line that answers one question at a time: the state of every motor, and the registers
// that somebody watches. Both decide only what is asked next; whoever owns the link decides when.
#pragma once

#include "drive/legacy/legacy_reader.h"
#include "drive/stop_sequence.h"
#include "drive/task.h"

#include <map>
#include <set>

namespace drive {

/// State, faults and speed of every motor: slow while nothing happens, fast while a start or a stop is under way.
class LegacyVitals : public Task<LegacyProtocol> {
public:
    static constexpr Duration kPeriod = std::chrono::milliseconds(100);
    static constexpr Duration kFastPeriod = std::chrono::milliseconds(20);
    static constexpr Duration kHurry = std::chrono::milliseconds(500);
    static constexpr Duration kLongestPause = std::chrono::milliseconds(250); ///< of one round

    explicit LegacyVitals(const LegacyFacts &board)
        : m_board(board)
    {
    }

    void restart(TimePoint now);
    void hurry(TimePoint now); ///< something was commanded: read at once and fast for a while
    std::optional<TimePoint> due() const { return m_due; }
    bool motorDriven() const { return !m_driven.empty(); }

    std::optional<legacy::Request> nextRequest(TimePoint now) override;
    void takeResponse(const legacy::Reply &response, TimePoint now) override;
    void takeNoResponse(std::optional<bool> executed, TimePoint now) override;

    std::vector<MotorStatus> takeStatuses() { return std::exchange(m_news, {}); }
    /// When the round behind the newest statuses began: evidence is never older than this.
    TimePoint askedAt() const { return m_askedAt; }

private:
    void publish(TimePoint now);

    const LegacyFacts &m_board;
    LegacyReader m_reader;
    std::map<RegisterId, Value> m_round;
    std::map<int, MotorState> m_states;
    std::set<int> m_driven; ///< motors that were last seen not idle
    std::vector<MotorStatus> m_news;
    std::optional<TimePoint> m_due;
    TimePoint m_fastUntil, m_askedAt, m_roundAsked;
};

/// The states of a run in their order, by the names that the statuses carry.
std::vector<StateStep> legacyStateSteps();

/// Reads the watched registers: those that are drawn (Watch::drawn) as often as the link gives, each in its turn, the others
/// once a period. What the build does not have is reported once and left out from then on.
class LegacyWatch : public Task<LegacyProtocol> {
public:
    explicit LegacyWatch(const LegacyFacts &board)
        : m_board(board)
    {
    }

    void watch(const Watch &watch, TimePoint now);
    void restart(TimePoint now); ///< a new connection
    std::optional<TimePoint> due() const;

    std::optional<legacy::Request> nextRequest(TimePoint now) override;
    void takeResponse(const legacy::Reply &response, TimePoint now) override;
    void takeNoResponse(std::optional<bool> executed, TimePoint now) override;

    std::vector<Reading> takeReadings() { return std::exchange(m_readings, {}); }

private:
    struct Entry {
        RegisterId id = 0;
        bool drawn = false;
        TimePoint due;
    };
    Entry *next(TimePoint now);

    const LegacyFacts &m_board;
    LegacyReader m_reader;
    Watch m_watch;
    std::vector<Entry> m_entries;
    std::vector<Reading> m_readings;
    TimePoint m_asked;
    unsigned m_drawnInRow = 0;
};

} // namespace drive
