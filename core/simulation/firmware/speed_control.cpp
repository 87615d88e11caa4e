// The loop keeps its integral where the mode changes, so that the torque does not jump.
#include "simulation/firmware/speed_control.h"

#include <algorithm>

namespace simulation {

namespace {

Pi::Gains gainsOf(const Tuning &t) { return {t.speedKp, t.speedKi, t.speedKpDiv, t.speedKiDiv}; }

} // namespace

void Ramp::start(std::int32_t target, int ticks)
{
    m_target = std::int64_t{target} * 65536;
    m_left = std::max(ticks, 0);
    if (m_left == 0)
        m_value = m_target;
}

void Ramp::step()
{
    if (m_left == 0)
        return;
    m_value += (m_target - m_value) / m_left;
    --m_left;
}

void SpeedControl::clear()
{
    m_loop.clear();
    m_out = 0;
    m_torque.set(0);
}

void SpeedControl::takeOver(std::int16_t speed_dHz, std::int16_t torque, const Tuning &tuning)
{
    m_loop.follow(gainsOf(tuning));
    m_loop.setIntegral(
        saturate32(std::int64_t{torque} << std::clamp<int>(tuning.speedKiDiv, 0, 31)));
    m_out = torque;
    m_torque.set(torque);
    m_speed.set(speed_dHz);
    m_mode = Mode::Speed;
}

void SpeedControl::rampTorque(std::int32_t target, int ms) { m_torque.start(target, ms); }

void SpeedControl::hold()
{
    m_speed.hold();
    m_torque.hold();
}

std::int16_t SpeedControl::step(std::int16_t speed_dHz, std::int32_t limit, const Tuning &tuning)
{
    m_speed.step();
    m_torque.step();
    if (m_mode == Mode::Torque) {
        m_out = saturate16(m_torque.value());
        return m_out;
    }
    m_loop.follow(gainsOf(tuning));
    m_loop.setOutputLimits({-limit, limit});
    const std::int32_t integral = saturate32(std::int64_t{limit} << m_loop.kiShift());
    m_loop.setIntegralLimits({-integral, integral});
    m_out = m_loop.step(m_speed.value() - speed_dHz);
    return m_out;
}

} // namespace simulation
