// Reads the watched registers over and over, in rounds at the wished period, or back to back where the link is slower.
// What the drive does not have is reported once and left out from then on.
#pragma once

#include "drive/mcb/mcb_reader.h"
#include "drive/task.h"

#include <set>

namespace drive {

class McbWatch : public Task {
public:
    explicit McbWatch(const McbBoard &board)
        : m_board(board)
    {
    }

    void watch(const Watch &watch, TimePoint now);
    void restart(TimePoint now); ///< a new connection: absent registers are asked again, once
    std::optional<TimePoint> due() const
    {
        return m_active ? std::optional<TimePoint>(m_due) : std::nullopt;
    }

    std::optional<Bytes> nextRequest(TimePoint now) override;
    void takeResponse(ByteView response, TimePoint now) override;
    void takeNoResponse(std::optional<bool> executed, TimePoint now) override;

    std::vector<Reading> takeReadings() { return std::exchange(m_readings, {}); }

private:
    void planNextRound(TimePoint now);

    const McbBoard &m_board;
    McbReader m_reader;
    Watch m_watch;
    std::set<RegisterId> m_missing;
    std::vector<Reading> m_readings;
    TimePoint m_roundStart, m_due;
    bool m_active = false;
};

/// A read of a person.
class McbReadTask : public WishTask {
public:
    McbReadTask(WishId id, const Read &read, const McbBoard &board)
        : WishTask(id, Permission::Always)
        , m_board(board)
        , m_ids(read.registers)
    {
    }
    bool onlyReads() const override { return true; }
    std::vector<Reading> takeReadings() override { return std::exchange(m_readings, {}); }
    std::optional<Bytes> nextRequest(TimePoint now) override;
    void takeResponse(ByteView response, TimePoint now) override;
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
