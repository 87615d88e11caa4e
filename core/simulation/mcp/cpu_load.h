// How busy the processor of a simulated board says it is. Nothing is measured: an idle board, a turning motor and a
// running datalog cost about what they cost on a 170 MHz part, with a wobble that repeats.
#pragma once

#include "simulation/signals.h"

#include <algorithm>
#include <cstdint>

namespace simulation {

class CpuLoad {
public:
    /// Once a millisecond; `signals` of the first motor carry the numbers. PERF_* show them.
    void measure(Signals &signals, int drivenMotors, bool logging)
    {
        constexpr float kIdle = 12.0F, kDriven = 21.0F, kLogging = 4.0F, kWobble = 0.25F;
        m_phase = static_cast<std::uint8_t>(m_phase * 5U + 1U); // full period
        const float wobble = kWobble * static_cast<float>(m_phase & 7U);
        signals.cpuLoad = kIdle + kDriven * static_cast<float>(drivenMotors)
            + (logging ? kLogging : 0.0F) + wobble;
        signals.cpuLoadMin =
            m_first ? signals.cpuLoad : std::min(signals.cpuLoadMin, signals.cpuLoad);
        signals.cpuLoadMax =
            m_first ? signals.cpuLoad : std::max(signals.cpuLoadMax, signals.cpuLoad);
        m_first = false;
    }

private:
    std::uint8_t m_phase = 0;
    bool m_first = true;
};

} // namespace simulation
