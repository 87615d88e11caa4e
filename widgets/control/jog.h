// Jog: a motor turns slowly while something is held, and stops when it is let go. It begins at an idle motor only, and
// any doubt ends it: a stop, a lost or silent link, another motor, the end of arming, a lost focus.
//
// What is held says so again and again, and the session stops the motor when it is not heard of
// (session/link/dead_man.h): a window that freezes does not see that a button was let go.
//
// Letting go stops this motor alone and leaves it armed; if it is not seen idle soon after, and in every other case,
// all motors are stopped for good.
#pragma once

#include "widgets/control/motion_allowed.h"

#include <QObject>

namespace widgets {

class MotionGate;

class Jog : public QObject {
    Q_OBJECT
public:
    static constexpr Milliseconds kIdleWithin{800}; ///< after it was let go

    Jog(Device &device, MotionGate &motion, QObject *parent = nullptr);

    MotionAllowed allowed() const; ///< whether it may begin
    double greatestRpm() const; ///< 0: the limit is not known
    bool held() const { return m_state == State::Held; }
    bool underWay() const { return m_state != State::Off; }

public Q_SLOTS:
    /// Not 0; cut to greatestRpm(). Does nothing if it may not begin. The first time it only notes that it has to be
    /// asked about: a question that opened now would be answered by the key that is held.
    void hold(std::int32_t rpm);
    void stamp(); ///< it is still held; from what is held itself, and from nothing else
    void release(); ///< let go; asks, if that is still to be done
    void abort(); ///< not let go, but lost: stops every motor
    void refresh(widgets::Milliseconds now);

Q_SIGNALS:
    void changed();

private:
    enum class State : std::uint8_t { Off, Held, LettingGo };
    void begin(std::int32_t rpm);
    void enter(State state);
    void statusChanged();

    Device &m_device;
    MotionGate &m_motion;
    State m_state = State::Off;
    int m_motor = 1;
    std::int32_t m_toAsk = 0; ///< rpm of what has to be agreed to, when it is let go
    bool m_left = false; ///< the motor was seen at work
    Milliseconds m_now{};
    Milliseconds m_deadline{};
};

} // namespace widgets
