// Watched registers in rounds: which ones a round asks for, what it brought, and when the next one begins. It asks nothing
// itself and knows no protocol.
#pragma once

#include "drive/event.h"

#include <set>

namespace drive {

class WatchRound {
public:
    void watch(const Watch &watch, TimePoint now);
    void restart(TimePoint now); ///< a new connection: absent registers are asked again, once

    /// When the next round begins; nothing if there is none.
    std::optional<TimePoint> due() const
    {
        return m_active ? std::optional<TimePoint>(m_due) : std::nullopt;
    }
    /// The registers of a round that begins now, each once; empty: none is due.
    std::vector<RegisterId> begin(TimePoint now);
    TimePoint begun() const { return m_begun; }
    /// What the drive does not have is reported once and left out from then on.
    void take(Reading reading);
    /// Sets the next round: a period after this one, or `atLeast` where the link needs longer.
    void planNext(Duration atLeast, TimePoint now);

    std::vector<Reading> takeReadings() { return std::exchange(m_readings, {}); }

private:
    std::vector<RegisterId> m_registers;
    Duration m_period{};
    std::set<RegisterId> m_missing;
    std::vector<Reading> m_readings;
    TimePoint m_begun, m_due;
    bool m_active = false;
};

} // namespace drive
