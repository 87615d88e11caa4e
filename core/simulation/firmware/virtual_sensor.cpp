// The speed changes once a millisecond, the angle every control period.
#include "simulation/firmware/virtual_sensor.h"

#include "simulation/maths/fixed_point.h"

#include <algorithm>
#include <cmath>

namespace simulation {

VirtualSensor::VirtualSensor(int polePairs, double hfHz)
    : m_perdHz(polePairs * 65536.0 / (10.0 * hfHz) * 65536.0)
{
}

void VirtualSensor::clear(std::int16_t angle)
{
    m_speed = m_target = m_change = 0;
    m_ticks = 0;
    m_turned = std::int64_t{angle} * 65536;
    m_angle = angle;
    m_steps = m_left = 0;
}

void VirtualSensor::accelerate(std::int32_t speed_dHz, int ticks)
{
    m_target = std::llround(speed_dHz * m_perdHz);
    m_ticks = std::max(ticks, 0);
    if (m_ticks == 0)
        m_speed = m_target;
    else
        m_change = (m_target - m_speed) / m_ticks;
}

void VirtualSensor::startTransition(int periods) { m_steps = m_left = std::max(periods, 1); }

void VirtualSensor::tick()
{
    if (m_ticks == 0)
        return;
    m_speed = --m_ticks == 0 ? m_target : m_speed + m_change;
}

std::int16_t VirtualSensor::step(std::int16_t other)
{
    m_turned += m_speed;
    m_angle = wrapAngle(static_cast<std::int32_t>(m_turned >> 16));
    if (m_steps > 0) {
        m_left = std::max(m_left - 1, 0);
        const std::int32_t apart = wrapAngle(other - m_angle);
        m_angle = wrapAngle(m_angle + apart * (m_steps - m_left) / m_steps);
    }
    return m_angle;
}

std::int16_t VirtualSensor::speed_dHz() const
{
    return saturate16(std::llround(static_cast<double>(m_speed) / m_perdHz));
}

} // namespace simulation
