// Reads the watched registers over and over, in rounds at the wished period, or back to back where the link is slower.
#pragma once

#include "drive/mcb/mcb_reader.h"
#include "drive/task.h"
#include "drive/watch_round.h"

namespace drive {

class McbWatch : public Task<McbProtocol> {
public:
    explicit McbWatch(const McbBoard &board)
        : m_board(board)
    {
    }

    void watch(const Watch &watch, TimePoint now);
    void restart(TimePoint now); ///< a new connection
    std::optional<TimePoint> due() const { return m_round.due(); }

    std::optional<McbRequest> nextRequest(TimePoint now) override;
    void takeResponse(const McbAnswer &answer, TimePoint now) override;
    void takeNoResponse(std::optional<bool> executed, TimePoint now) override;

    std::vector<Reading> takeReadings() { return m_round.takeReadings(); }

private:
    void planNextRound(TimePoint now);

    const McbBoard &m_board;
    McbReader m_reader;
    WatchRound m_round;
};

/// A read of a person.
class McbReadTask : public WishTask<McbProtocol> {
public:
    McbReadTask(WishId id, const Read &read, const McbBoard &board)
        : WishTask(id, Permission::Always)
        , m_board(board)
        , m_ids(read.registers)
    {
    }
    bool onlyReads() const override { return true; }
    std::vector<Reading> takeReadings() override { return std::exchange(m_readings, {}); }
    std::optional<McbRequest> nextRequest(TimePoint now) override;
    void takeResponse(const McbAnswer &answer, TimePoint now) override;
    void takeNoResponse(std::optional<bool> executed, TimePoint now) override;

private:
    void finish();

    const McbBoard &m_board;
    std::vector<RegisterId> m_ids;
    McbReader m_reader;
    std::vector<Reading> m_readings;
    bool m_started = false;
};

} // namespace drive
