// TimeGap: whether time has passed in which this program did not run: it was stopped, starved, or the computer slept.
// What was known before a gap is old, and what waits to be done was meant for another time. Pure: times are arguments.
#pragma once

#include "base/time.h"

#include <algorithm>
#include <optional>

namespace session {

class TimeGap {
public:
    static constexpr Duration kLeast = std::chrono::seconds(1);

    /// At every turn, before anything is done in it.
    /// @param now      of the clock that timers run by
    /// @param elapsed  of one that goes on while the computer sleeps; may be the same
    /// @param due      when the owner had asked to be woken at the latest; empty: it had not
    /// @return  how long nothing ran, if that is longer than kLeast; otherwise zero
    Duration notice(TimePoint now, TimePoint elapsed, std::optional<TimePoint> due)
    {
        const Duration slept =
            m_elapsed ? (elapsed - *m_elapsed) - (now - m_now) : Duration::zero();
        m_elapsed = elapsed;
        m_now = now;
        const Duration gap = std::max(due ? now - *due : Duration::zero(), slept);
        return gap > kLeast ? gap : Duration::zero();
    }

private:
    std::optional<TimePoint> m_elapsed;
    TimePoint m_now{};
};

} // namespace session
