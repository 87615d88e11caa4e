// Stages of no length are taken at once, in the same tick.
#include "simulation/firmware/rev_up.h"

namespace simulation {

void RevUp::begin(int direction)
{
    m_direction = direction;
    m_next = 0;
    m_left = 0;
    m_torque = m_torqueTarget = 0;
}

RevUp::Step RevUp::step(const Stages &stages)
{
    Step out;
    while (m_left == 0) {
        m_torque = m_torqueTarget;
        if (m_next == kStages) {
            out.over = true;
            break;
        }
        const StageDigits &stage = stages[m_next++];
        m_left = stage.ms;
        m_torqueTarget = std::int64_t{m_direction} * stage.torque * 65536;
        out.begins = true;
        out.speed_dHz = m_direction * stage.rpm / 6;
        out.ticks = stage.ms;
    }
    if (m_left > 0) {
        m_torque += (m_torqueTarget - m_torque) / m_left;
        --m_left;
    }
    out.torque = static_cast<std::int16_t>(m_torque >> 16);
    return out;
}

} // namespace simulation
