// What the motors of a simulated board did lately, in truth: what a screen may still say.
#pragma once

#include "base/time.h"
#include "simulation/simulated_board.h"

#include <algorithm>
#include <deque>
#include <set>
#include <vector>

namespace support {

class BoardHistory {
public:
    static constexpr Duration kKept = std::chrono::seconds(8);

    /// All of one motor in a span of time.
    struct Span {
        bool known = false; ///< the motor is there, and its state was read
        std::set<simulation::MotorState> states;
        double leastRpm = 0.0, greatestRpm = 0.0; ///< as the firmware measures it
        double leastReference = 0.0, greatestReference = 0.0;
        bool faultPresent = false, noneToKeep = false; ///< at some time
        bool nonePresent = false, faultKept = false;
        bool driven = false, rested = false;
        double maxRpm = 0.0; ///< that the board tells
    };

    void add(TimePoint now, std::vector<simulation::MotorTruth> motors)
    {
        for (std::size_t i = 0; i < motors.size(); ++i) {
            const std::uint32_t before = m_moments.empty() || i >= m_moments.back().motors.size()
                ? 0
                : m_moments.back().motors[i].faults;
            const std::uint32_t fresh = motors[i].faults & ~before;
            if (fresh != 0)
                m_faults.push_back({now, static_cast<int>(i) + 1, (fresh & 0xFFFFU) != 0,
                    (before & 0xFFFFU) == 0});
        }
        m_moments.push_back({now, std::move(motors)});
        while (m_moments.front().at + kKept < now)
            m_moments.pop_front();
    }

    /// @param from  what stood then counts, too
    Span span(int motor, TimePoint from, TimePoint to) const
    {
        Span all;
        const auto index = static_cast<std::size_t>(motor - 1);
        for (std::size_t i = 0; i < m_moments.size(); ++i) {
            const bool stands = i + 1 == m_moments.size() || m_moments[i + 1].at > from;
            if (!stands || m_moments[i].at > to || index >= m_moments[i].motors.size())
                continue;
            include(all, m_moments[i].motors[index]);
        }
        return all;
    }

    struct Fault {
        TimePoint at;
        int motor;
        bool kept; ///< now, and not before; else it is there again, and still kept from before
        bool alone; ///< none was kept before
    };
    bool isDriven() const ///< any motor, at the newest moment
    {
        return !m_moments.empty()
            && std::any_of(m_moments.back().motors.begin(), m_moments.back().motors.end(),
                [](const simulation::MotorTruth &is) { return is.driven; });
    }
    /// Each fault that came.
    const std::vector<Fault> &faults() const { return m_faults; }

private:
    struct Moment {
        TimePoint at;
        std::vector<simulation::MotorTruth> motors;
    };

    static void include(Span &all, const simulation::MotorTruth &is)
    {
        const bool first = !std::exchange(all.known, true);
        const auto widen = [first](double &least, double &greatest, double value) {
            least = first ? value : std::min(least, value);
            greatest = first ? value : std::max(greatest, value);
        };
        all.states.insert(is.state);
        widen(all.leastRpm, all.greatestRpm, is.measuredRpm);
        widen(all.leastReference, all.greatestReference, is.referenceRpm);
        ((is.faults >> 16) != 0 ? all.faultPresent : all.nonePresent) = true;
        ((is.faults & 0xFFFFU) != 0 ? all.faultKept : all.noneToKeep) = true;
        (is.driven ? all.driven : all.rested) = true;
        all.maxRpm = is.maxRpm;
    }

    std::deque<Moment> m_moments;
    std::vector<Fault> m_faults;
};

} // namespace support
