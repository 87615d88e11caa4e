// The course in which a motor goes to and fro between two set-points, by a ramp each way, and is held at either end.
#pragma once

#include "lab/course.h"

#include <utility>

namespace lab {

class ToAndFro : public Course {
public:
    struct Way {
        Ask what; ///< where it ends
        milliseconds ramp{0}; ///< 0: at once
    };

    /// @param hold    at either end, behind its ramp
    /// @param rounds  there and back
    ToAndFro(Way there, Way back, milliseconds hold, std::int64_t rounds)
        : m_there(std::move(there))
        , m_back(std::move(back))
        , m_hold(hold)
        , m_rounds(rounds)
    {
    }
    std::optional<Ask> next(const Moment &moment) override
    {
        if (!moment.answered || over())
            return std::nullopt;
        if (m_ways > 0 && !std::exchange(m_timed, true)) // from the answer on
            m_due = moment.now + way().ramp + m_hold;
        if (m_ways > 0 && moment.now < m_due)
            return std::nullopt;
        ++m_ways;
        m_timed = false;
        if (over())
            return std::nullopt;
        return way().what;
    }
    TimePoint due() const override { return m_due; }
    bool over() const override { return m_ways > 2 * m_rounds; }

private:
    const Way &way() const { return m_ways % 2 == 1 ? m_there : m_back; } ///< the last one

    Way m_there, m_back;
    milliseconds m_hold;
    std::int64_t m_rounds;
    std::int64_t m_ways = 0; ///< asked for
    bool m_timed = false; ///< the time of the last one runs
    TimePoint m_due{};
};

} // namespace lab
