// Whether a measured speed can be: out of its range so many times in a row, a sensor is no longer believed.
#pragma once

#include <cstdint>

namespace simulation {

struct SpeedRange {
    std::uint16_t max_dHz = 767, min_dHz = 0; ///< mechanical, size
    int errorsBeforeFault = 3;
};

class SpeedRangeCheck {
public:
    explicit SpeedRangeCheck(SpeedRange range)
        : m_range(range)
    {
    }

    /// One average more. Past the limit it stays unreliable until clear().
    void look(std::int16_t speed_dHz)
    {
        const int size = speed_dHz < 0 ? -int{speed_dHz} : int{speed_dHz};
        const bool good = size <= m_range.max_dHz && size >= m_range.min_dHz;
        if (reliable())
            m_errors = good ? 0 : m_errors + 1;
    }
    void fail() { m_errors = m_range.errorsBeforeFault; }
    void clear() { m_errors = 0; }
    bool reliable() const { return m_errors < m_range.errorsBeforeFault; }

private:
    SpeedRange m_range;
    int m_errors = 0;
};

} // namespace simulation
