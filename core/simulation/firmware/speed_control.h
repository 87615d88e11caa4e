// Speed and torque references: their ramps in the firmware's units, and the speed loop that makes torque of speed.
// It runs at 1 kHz and measures nothing. Source: features 6.1 (6 rpm steps), 6.2 (PI); firmware 6.x, speed and torque
// control.
#pragma once

#include "simulation/maths/pi.h"
#include "simulation/signals.h"

#include <cstdint>

namespace simulation {

/// A straight line in time, in whole digits with 16 more bits.
class Ramp {
public:
    void set(std::int32_t value) { start(value, 0); }
    void start(std::int32_t target, int ticks); ///< 0: there at once
    void step();
    void hold() { start(value(), 0); }
    std::int32_t value() const { return static_cast<std::int32_t>((m_value + 0x8000) >> 16); }

private:
    std::int64_t m_value = 0, m_target = 0;
    int m_left = 0;
};

class SpeedControl {
public:
    enum class Mode : std::uint8_t { Speed, Torque };

    void clear();
    /// The speed loop takes over where `torque` flows and the speed is `speed_dHz`.
    void takeOver(std::int16_t speed_dHz, std::int16_t torque, const Tuning &tuning);
    void rampSpeed(std::int32_t target_dHz, int ms) { m_speed.start(target_dHz, ms); }
    void rampTorque(std::int32_t target, int ms);
    void hold();
    /// One tick: the reference of the q current, within +-limit.
    std::int16_t step(std::int16_t speed_dHz, std::int32_t limit, const Tuning &tuning);

    Mode mode() const { return m_mode; }
    void setMode(Mode mode) { m_mode = mode; }
    std::int32_t speedReference_dHz() const { return m_speed.value(); }
    std::int16_t torqueReference() const { return m_out; }

private:
    Mode m_mode = Mode::Speed;
    Ramp m_speed, m_torque;
    Pi m_loop;
    std::int16_t m_out = 0;
};

} // namespace simulation
