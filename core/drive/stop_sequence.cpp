#include "drive/stop_sequence.h"

#include <algorithm>
#include <cmath>

namespace drive {

bool isDriveIdle(const MotorStatus &status)
{
    return status.state == MotorState::Idle || status.state == MotorState::FaultNow
        || status.state == MotorState::FaultOver || status.waitsForBus;
}

void StopSequence::begin(int motors, TimePoint now)
{
    m_begun = now;
    m_motors.clear();
    for (int number = 1; number <= motors; ++number) {
        Motor motor;
        motor.number = number;
        motor.nextStop = now;
        m_motors.push_back(motor);
        tell(motor, StopWord::Requested, now);
    }
}

bool StopSequence::exclusive() const
{
    return std::any_of(
        m_motors.begin(), m_motors.end(), [](const Motor &motor) { return !motor.idle; });
}

bool StopSequence::alarmed() const
{
    return std::any_of(m_motors.begin(), m_motors.end(),
        [](const Motor &motor) { return motor.alarmed && !motor.idle; });
}

std::optional<int> StopSequence::stopDue(TimePoint now, bool connected) const
{
    if (!connected && !blind(now))
        return std::nullopt;
    for (const Motor &motor : m_motors)
        if (!motor.idle && motor.nextStop <= now)
            return motor.number;
    return std::nullopt;
}

void StopSequence::stopSent(int number, TimePoint now)
{
    if (Motor *motor = find(number)) {
        if (!motor->firstSent)
            motor->firstSent = now;
        motor->nextStop = now + kRepeat;
    }
}

void StopSequence::stopAnswered(int number, TimePoint now)
{
    Motor *motor = find(number);
    if (motor != nullptr && !std::exchange(motor->accepted, true))
        tell(*motor, StopWord::Accepted, now);
}

void StopSequence::takeStatus(const MotorStatus &status, TimePoint askedAt)
{
    Motor *motor = find(status.motor);
    if (motor == nullptr || !motor->firstSent || askedAt < *motor->firstSent)
        return;
    if (!isDriveIdle(status)) {
        motor->idleReadings = motor->slowReadings = 0;
        return;
    }
    if (++motor->idleReadings < kIdleReadings)
        return;
    if (!std::exchange(motor->idle, true))
        tell(*motor, StopWord::DriveIdle, status.at);
    if (!status.speedRpm || std::abs(*status.speedRpm) >= kStandstillRpm)
        motor->slowReadings = 0;
    else if (++motor->slowReadings >= kStandstillReadings
        && !std::exchange(motor->standstill, true))
        tell(*motor, StopWord::Standstill, status.at);
    if (std::all_of(m_motors.begin(), m_motors.end(), [](const Motor &m) { return m.standstill; }))
        end();
}

void StopSequence::handleTimeout(TimePoint now)
{
    if (now < m_begun + kConfirmWithin)
        return;
    for (Motor &motor : m_motors)
        if (!motor.idle && !std::exchange(motor.alarmed, true))
            tell(motor, StopWord::NotConfirmed, now);
}

std::optional<TimePoint> StopSequence::nextStop(bool connected, TimePoint now) const
{
    std::optional<TimePoint> due;
    for (const Motor &motor : m_motors)
        if (!motor.idle && (!due || motor.nextStop < *due))
            due = motor.nextStop;
    if (due && !connected && std::max(*due, now) >= blindUntil())
        return std::nullopt;
    return due;
}

std::optional<TimePoint> StopSequence::nextAlarm() const
{
    const bool pending = std::any_of(m_motors.begin(), m_motors.end(),
        [](const Motor &motor) { return !motor.idle && !motor.alarmed; });
    return pending ? std::optional<TimePoint>(m_begun + kConfirmWithin) : std::nullopt;
}

StopSequence::Motor *StopSequence::find(int number)
{
    const auto at = std::find_if(m_motors.begin(), m_motors.end(),
        [&](const Motor &motor) { return motor.number == number; });
    return at == m_motors.end() ? nullptr : &*at;
}

void StopSequence::tell(const Motor &motor, StopWord word, TimePoint at)
{
    m_progress.push_back({motor.number, word, at});
}

} // namespace drive
