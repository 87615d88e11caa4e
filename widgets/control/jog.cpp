#include "widgets/control/jog.h"

#include "drive/motion_caution.h"
#include "widgets/control/motion_gate.h"

#include <algorithm>
#include <utility>

namespace widgets {

Jog::Jog(Device &device, MotionGate &motion, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_motion(motion)
{
    // A stop comes first and is enough: what follows from it must not stop again.
    connect(&device, &Device::stopWished, this, [this] { enter(State::Off); });
    connect(&device, &Device::statusChanged, this, &Jog::statusChanged);
    connect(&device, &Device::motorChanged, this, &Jog::abort);
    connect(&device, &Device::identityChanged, this, &Jog::abort);
    connect(&device, &Device::armedStateChanged, this, [this](bool armed) {
        if (!armed)
            abort();
    });
    connect(&device, &Device::linkStateChanged, this, [this] {
        if (!m_device.answering())
            abort();
    });
    connect(&device, &Device::interrupted, this, [this](const session::Interruption &what) {
        if (what.cause != session::Interruption::Cause::Hold || m_state != State::Held)
            return;
        m_deadline = m_now + kIdleWithin; // the session has stopped it
        m_motion.dropRest();
        enter(State::LettingGo);
    });
    connect(&device, &Device::portStateChanged, this, [this] {
        if (!m_device.portOpen())
            enter(State::Off); // nothing can carry a stop; the window says so
    });
}

MotionAllowed Jog::allowed() const
{
    if (MotionAllowed ramp = motionAllowed(m_device, drive::Feature::SpeedRamp); !ramp.yes)
        return ramp;
    if (!(greatestRpm() > 0.0))
        return {false, tr("Jogging needs a limit of speed: set one of your own.")};
    return startAllowed(m_device);
}

double Jog::greatestRpm() const
{
    // Expert mode's ceiling is none to jog under: it only tells a misread number from a speed.
    const drive::MotorLimits limits = m_device.limits(m_device.motor());
    return drive::kGreatestQuietStep * drive::realBoundsOf(limits, m_device.userLimits()).rpm;
}

void Jog::hold(std::int32_t rpm)
{
    if (underWay() || !allowed().yes)
        return;
    const auto most = static_cast<std::int32_t>(greatestRpm());
    if (rpm == 0 || most == 0)
        return;
    m_motor = m_device.motor();
    m_left = false;
    const std::int32_t slow = std::clamp(rpm, -most, most);
    if (!m_motion.jogAgreed(m_motor))
        m_toAsk = slow;
    else
        begin(slow);
}

void Jog::begin(std::int32_t rpm)
{
    Q_EMIT m_device.held(m_motor); // before anything moves
    if (m_motion.jog(tr("Jog"), m_motor, rpm))
        enter(State::Held);
    else
        Q_EMIT m_device.released();
}

void Jog::stamp()
{
    if (m_state == State::Held)
        Q_EMIT m_device.held(m_motor);
}

void Jog::release()
{
    if (const std::int32_t rpm = std::exchange(m_toAsk, 0); rpm != 0 && allowed().yes) {
        m_motion.jog(tr("Jog"), m_device.motor(), rpm);
        return;
    }
    if (m_state != State::Held)
        return;
    if (m_motion.asking()) // it takes nothing now, not even this stop
        return abort();
    m_deadline = m_now + kIdleWithin;
    m_motion.dropRest();
    enter(State::LettingGo);
    m_motion.want(tr("Stop"), drive::Command{drive::MotorAction::StopMotor, m_motor});
}

void Jog::abort()
{
    m_toAsk = 0;
    if (m_state == State::Off)
        return;
    enter(State::Off);
    m_device.stop();
}

void Jog::refresh(Milliseconds now)
{
    m_now = now;
    if (m_state != State::LettingGo || now <= m_deadline)
        return;
    if (drive::rests(m_device.status(m_motor).state))
        enter(State::Off);
    else
        abort(); // the stop that is repeated until there is evidence
}

void Jog::statusChanged()
{
    if (m_state == State::Off)
        return;
    const bool rest = drive::rests(m_device.status(m_motor).state);
    m_left = m_left || !rest;
    // Before the start has left, the motor is idle as well; afterwards idle means that it is over.
    if (rest && (m_left || m_device.status(m_motor).state != drive::MotorState::Idle))
        enter(State::Off);
}

void Jog::enter(State state)
{
    if (m_state == state)
        return;
    if (std::exchange(m_state, state) == State::Held)
        Q_EMIT m_device.released();
    Q_EMIT changed();
}

} // namespace widgets
