// Goes to an angle of the shaft: a path there in a given time, and the PID that makes torque of what is missing. Runs
// at 1 kHz, on an encoder. Source: POSITION_* registers; mcp-aspep sections 7 and 8.
#pragma once

#include "simulation/signals.h"

#include <cstdint>

namespace simulation {

class PositionControl {
public:
    /// Angles of the shaft in 1/65536 turn, turns included.
    using Digits = std::int64_t;
    enum class State : std::uint8_t { Ready = 0, Moving = 1, Reached = 2, Following = 3 };

    void clear() { *this = PositionControl(); }
    /// From where the path is, or `now` if there is none, to `target`; without a time it is followed as it is given.
    void move(Digits now, Digits target, int ticks);
    /// One tick: the torque, within +-limit, digits.
    std::int16_t step(Digits now, std::int32_t limit, const Tuning &tuning);

    State state() const { return m_state; }
    static Digits digitsOf(double rad);

private:
    Digits reference() const;

    State m_state = State::Ready;
    Digits m_from = 0, m_target = 0;
    int m_ticks = 0, m_done = 0;
    std::int64_t m_integral = 0, m_lastError = 0;
};

} // namespace simulation
