// The registers that somebody watches, on a line that answers one question at a time. Decides only what is asked next; whoever
// owns the link decides when.
#pragma once

#include "drive/legacy/legacy_reader.h"
#include "drive/task.h"

namespace drive {

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
    LegacyReader m_reader{m_board};
    Watch m_watch;
    std::vector<Entry> m_entries;
    std::vector<Reading> m_readings;
    TimePoint m_asked;
    unsigned m_drawnInRow = 0;
};

} // namespace drive
