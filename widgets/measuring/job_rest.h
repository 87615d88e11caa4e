// When a tool that follows the picture may compute again: one job at a time, and then it rests for twice as long as
// that took. A picture that runs asks for another one with each frame, and a long one would take a whole core for as
// long as it is seen.
#pragma once

#include <QElapsedTimer>

#include <algorithm>

namespace widgets {

class JobRest {
public:
    /// @param least_ms  from one beginning to the next
    explicit JobRest(qint64 least_ms = 0)
        : m_least_ms(least_ms)
    {
    }

    bool busy() const { return m_busy; }
    /// @param runs  the picture does; of one that stands another is wanted only because the user chose it
    bool over(bool runs) const
    {
        return !m_busy && (!runs || !m_clock.isValid() || m_clock.elapsed() >= m_rest_ms);
    }
    void begin()
    {
        m_busy = true;
        m_clock.start();
    }
    void end()
    {
        constexpr int kTimes = 2;
        constexpr qint64 kMost_ms = 2000; // the user may have chosen another meanwhile
        m_busy = false;
        const qint64 took_ms = m_clock.restart();
        m_rest_ms = std::max(std::min(kTimes * took_ms, kMost_ms), m_least_ms - took_ms);
    }

private:
    qint64 m_least_ms;
    QElapsedTimer m_clock; ///< since the job began, then since it ended
    qint64 m_rest_ms = 0;
    bool m_busy = false;
};

} // namespace widgets
