// The speed sensor that senses nothing: an angle that turns as the rev-up wants it, and the blend from it to a real
// sensor's angle in the switch-over. It knows no motor.
// Source: virtual speed sensor of firmware 6.x: speed in turns/65536 a control period with 16 more bits.
#pragma once

#include <cstdint>

namespace simulation {

class VirtualSensor {
public:
    VirtualSensor(int polePairs, double hfHz);

    void clear(std::int16_t angle);
    /// From the present speed to `speed_dHz` (mechanical) in so many ticks of the 1 kHz task; 0: at once.
    void accelerate(std::int32_t speed_dHz, int ticks);
    /// From now on the angle moves from its own to the other sensor's, within so many control periods.
    void startTransition(int periods);

    /// One control period on; `other` is the angle of the sensor that takes over.
    std::int16_t step(std::int16_t other);
    /// One tick of the 1 kHz task on: the speed.
    void tick();

    std::int16_t angle() const { return m_angle; }
    std::int16_t perPeriod() const { return static_cast<std::int16_t>(m_speed >> 16); }
    std::int16_t speed_dHz() const;
    bool transitionEnded() const { return m_steps > 0 && m_left == 0; }

private:
    double m_perdHz; ///< angle a period, with 16 more bits
    std::int64_t m_speed = 0, m_target = 0, m_change = 0;
    int m_ticks = 0;
    std::int64_t m_turned = 0; ///< own angle, with 16 more bits
    std::int16_t m_angle = 0;
    int m_steps = 0, m_left = 0;
};

} // namespace simulation
