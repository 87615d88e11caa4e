#include "drive/stop_sequence.h"

#include <algorithm>
#include <cmath>

namespace drive {

bool isDriveIdle(const MotorStatus &status) { return rests(status.state) || status.waitsForBus; }

MotionEntry entryOf(const StopProgress &progress, TimePoint asked, MotionEntry entry)
{
    entry.act = MotionAct::Stop;
    entry.motor = progress.motor;
    entry.asked = asked;
    entry.ended = std::max(asked, progress.at);
    entry.stop = progress.word;
    const bool sure =
        progress.word != StopWord::Requested && progress.word != StopWord::NotConfirmed;
    entry.outcome = sure ? Outcome::Ok : Outcome::Unknown;
    return entry;
}

void StopSequence::begin(int motors, TimePoint now, int expected)
{
    m_known = motors;
    if (!active())
        m_count = Count::AtLeast;
    m_blindUntil = now + kBlindTime;
    std::erase_if(m_motors, [](const Motor &motor) { return motor.idle; });
    for (Motor &motor : m_motors)
        motor.nextStop = std::min(motor.nextStop, now); // the motor that waits longest stays first
    add(std::max(motors, expected), now);
}

void StopSequence::follow(int motors, Count count, TimePoint now)
{
    if (!active())
        return;
    m_known = motors;
    m_count = count;
    if (count == Count::Exactly)
        std::erase_if(m_motors, [&](const Motor &motor) { return motor.number > motors; });
    add(motors, now);
    endAtStandstill();
}

void StopSequence::add(int motors, TimePoint now)
{
    for (int number = 1; number <= motors; ++number) {
        if (find(number) != nullptr)
            continue;
        m_motors.push_back({.number = number, .begun = now, .nextStop = now});
        tell(m_motors.back(), StopWord::Requested, now);
    }
}

bool StopSequence::allIdle() const { return std::ranges::all_of(m_motors, &Motor::idle); }

bool StopSequence::alarmed() const
{
    return std::ranges::any_of(
        m_motors, [](const Motor &motor) { return motor.alarmed && !motor.idle; });
}

bool StopSequence::wantsStop(const Motor &motor, bool connected) const
{
    return !motor.idle && (!connected || motor.number <= m_known);
}

std::optional<int> StopSequence::stopDue(TimePoint now, bool connected) const
{
    if (!connected && !blind(now))
        return std::nullopt;
    const Motor *due = nullptr; // waiting for longest: each has its turn where no answer comes
    for (const Motor &motor : m_motors)
        if (wantsStop(motor, connected) && motor.nextStop <= now
            && (due == nullptr || motor.nextStop < due->nextStop))
            due = &motor;
    return due == nullptr ? std::nullopt : std::optional(due->number);
}

Duration StopSequence::turn() const
{
    const auto motors =
        std::ranges::count_if(m_motors, [](const Motor &motor) { return !motor.idle; });
    return std::max(kLeastTurn, kRepeat / std::max<std::int64_t>(motors, 1));
}

void StopSequence::stopSent(int number, TimePoint now)
{
    if (Motor *motor = find(number)) {
        if (!motor->firstSent)
            motor->firstSent = now;
        motor->nextStop = now + kRepeat;
    }
}

void StopSequence::stopFailed(int number, TimePoint now)
{
    if (Motor *motor = find(number))
        motor->nextStop = now;
}

void StopSequence::stopAnswered(int number, TimePoint now)
{
    Motor *motor = find(number);
    if (motor != nullptr && !std::exchange(motor->accepted, true))
        tell(*motor, StopWord::Accepted, now);
}

void StopSequence::acceptStatus(const MotorStatus &status, TimePoint askedAt)
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
    // What an observer reads of a rotor that nothing drives says nothing about it, so there is nothing to wait for.
    const bool measured = status.speedMeasured.value_or(true);
    const bool slow = status.speedRpm && std::abs(*status.speedRpm) < kStandstillRpm;
    if (!status.speedMeasured || (measured && !slow))
        motor->slowReadings = 0;
    else if (++motor->slowReadings >= kStandstillReadings
        && !std::exchange(motor->standstill, true))
        tell(*motor, measured ? StopWord::Standstill : StopWord::MayCoast, status.at);
    endAtStandstill();
}

void StopSequence::handleTimeout(TimePoint now)
{
    for (Motor &motor : m_motors)
        if (!motor.idle && now >= motor.begun + kConfirmWithin
            && !std::exchange(motor.alarmed, true))
            tell(motor, StopWord::NotConfirmed, now);
}

std::optional<TimePoint> StopSequence::nextStop(bool connected, TimePoint now) const
{
    std::optional<TimePoint> due;
    for (const Motor &motor : m_motors)
        if (wantsStop(motor, connected))
            earliest(due, motor.nextStop);
    if (due && !connected && std::max(*due, now) >= blindUntil())
        return std::nullopt;
    return due;
}

std::optional<TimePoint> StopSequence::nextAlarm() const
{
    std::optional<TimePoint> due;
    for (const Motor &motor : m_motors)
        if (!motor.idle && !motor.alarmed)
            earliest(due, motor.begun + kConfirmWithin);
    return due;
}

void StopSequence::endAtStandstill()
{
    if (m_count == Count::Exactly && std::ranges::all_of(m_motors, &Motor::standstill))
        end();
}

StopSequence::Motor *StopSequence::find(int number)
{
    const auto at = std::ranges::find(m_motors, number, &Motor::number);
    return at == m_motors.end() ? nullptr : &*at;
}

void StopSequence::tell(const Motor &motor, StopWord word, TimePoint at)
{
    m_progress.push_back({motor.number, word, at});
}

} // namespace drive
