// RampProgress: how far a ramp is that was sent, from the clock it is given, the board's own set-point and what is
// measured. No widget and no clock of its own; it says only what can be known, and ends with the reason.
#pragma once

#include "drive/event.h"
#include "widgets/base/device.h"

#include <optional>

namespace widgets {

class RampProgress {
public:
    enum class Phase : std::uint8_t {
        None, ///< nothing was sent yet
        Waiting, ///< the board has taken it; it goes when the motor runs
        Ramping,
        Following, ///< the set-point has arrived, the motor has not
        Arrived,
        Replaced, ///< another set-point took over, or the ramp was stopped
        MotorStopped, ///< it runs no more
        LinkLost, ///< not known
    };

    /// What there is to see at one moment, in the ramp's unit.
    struct Sight {
        drive::MotorState state = drive::MotorState::Unknown;
        bool answering = true;
        std::optional<double> reference; ///< the board's set-point
        std::optional<double> measured;
        bool moving() const { return state == drive::MotorState::Running; }
    };

    /// @param step  what the device can resolve; > 0
    void begin(
        double target, Milliseconds duration, double step, Milliseconds now, const Sight &sight);
    void update(Milliseconds now, const Sight &sight);
    void replaced(); ///< the user has sent something else, or stopped the ramp
    void clear() { *this = {}; }

    Phase phase() const { return m_phase; }
    bool running() const
    {
        return m_phase == Phase::Waiting || m_phase == Phase::Ramping
            || m_phase == Phase::Following;
    }
    double target() const { return m_target; }
    double from() const { return m_from; } ///< set-point at the beginning; speed after a start-up
    Milliseconds duration() const { return m_duration; }
    Milliseconds elapsed() const { return m_elapsed; } ///< since it goes
    double fraction() const; ///< of the time, 0 to 1

private:
    bool offTheRamp(const Sight &sight) const;

    Phase m_phase = Phase::None;
    double m_from = 0.0, m_target = 0.0, m_step = 1.0;
    bool m_fromKnown = true; ///< not of a ramp that waited: it begins where the start-up ends
    Milliseconds m_duration{}, m_begun{}, m_elapsed{};
};

} // namespace widgets
