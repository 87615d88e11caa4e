#include "experiments/running_motor.h"

#include "drive/values.h"
#include "lab/waits.h"
#include "motor_facts.h"
#include "sentences.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cli {

using drive::MotorState;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

namespace {

/// The first status that is meant, or the last one of that time.
template <class Meant>
Outcome<drive::MotorStatus> statusWithin(Desk &desk, steady_clock::duration limit, Meant meant)
{
    const auto until = steady_clock::now() + limit;
    auto status = desk.talk.nextStatus(desk.arguments.motor);
    while (status && !meant(*status) && steady_clock::now() < until)
        status = desk.talk.nextStatus(desk.arguments.motor);
    return status;
}

QString rpmText(double rpm) { return QStringLiteral("%1 rpm").arg(std::lround(rpm)); }

/// References that are not 0 now and would be afterwards, by name. Empty: none.
Outcome<QString> lostReferences(
    Desk &desk, const lab::Subject &subject, const std::vector<lab::Experiment> &wanted)
{
    std::vector<drive::RegisterId> ids;
    for (const lab::Experiment &one : wanted)
        for (const drive::RegisterId id : lab::conditionsOf(one).zeroBefore)
            if (id != 0)
                ids.push_back(id);
    const auto readings = desk.talk.read(ids);
    if (!readings)
        return tl::make_unexpected(readings.error());
    for (const drive::Reading &reading : *readings) {
        const auto digits = drive::asNumber(reading.value);
        const double factor = desk.catalog().readScale(reading.id).factor;
        if (reading.status == drive::ReadStatus::Ok && digits
            && lab::flows(*digits * factor, subject.limits))
            return QString::fromStdString(subject.nameOf(reading.id));
    }
    return QString();
}

} // namespace

RunningMotor::RunningMotor(
    Desk &desk, lab::Subject subject, int rpm, std::optional<milliseconds> ramp)
    : m_desk(desk)
    , m_subject(std::move(subject))
    , m_rpm(rpm)
    , m_ramp(ramp)
{
}

Outcome<bool> RunningMotor::stop()
{
    if (const auto armed = m_desk.talk.armToMove(); !armed)
        return tl::make_unexpected(armed.error());
    const drive::Command stop{drive::MotorAction::StopMotor, m_subject.motor};
    if (const auto ended = m_desk.talk.command(stop, QStringLiteral("The stop")); !ended)
        return tl::make_unexpected(ended.error());
    const auto idle = [](const drive::MotorStatus &it) { return it.state == MotorState::Idle; };
    const auto status = statusWithin(m_desk, lab::kRestsWithin, idle);
    if (!status)
        return tl::make_unexpected(status.error());
    if (!idle(*status))
        return failure(kRefused,
            QStringLiteral("The motor was not seen to stop: %1.").arg(stateText(*status)));
    return true;
}

Outcome<bool> RunningMotor::goOn()
{
    const drive::MotorLimits &limits = m_subject.limits;
    const bool seen = m_subject.seesRotor();
    const auto rested = statusWithin(
        m_desk, seen ? lab::kCoastsSeen : lab::kCoastsUnseen, [&](const drive::MotorStatus &it) {
            return seen && lab::isStill(it.speedRpm, limits.maxSpeedRpm, limits);
        });
    if (!rested)
        return tl::make_unexpected(rested.error());
    if (rested->state != MotorState::Idle)
        return failure(kRefused,
            QStringLiteral("The motor is not started again: %1.").arg(stateText(*rested)));
    if (seen && !lab::isStill(rested->speedRpm, limits.maxSpeedRpm, limits)
        && rested->speedRpm.value_or(0.0) * m_rpm < 0.0)
        return failure(kRefused,
            QStringLiteral("The motor is not started again: it still turns the other way."));
    const int motor = m_subject.motor;
    const drive::SpeedRamp gently{motor, m_rpm, lab::kApproach};
    if (const auto ended = m_desk.talk.command(gently, QStringLiteral("The way back")); !ended)
        return tl::make_unexpected(ended.error());
    const drive::Command start{drive::MotorAction::Start, motor};
    if (const auto ended = m_desk.talk.command(start, QStringLiteral("The start")); !ended)
        return tl::make_unexpected(ended.error());
    if (const auto there = reach(); !there || !m_ramp)
        return there;
    return m_desk.talk
        .command(drive::SpeedRamp{motor, m_rpm, *m_ramp}, QStringLiteral("Its ramp of before"))
        .map([](int) { return true; });
}

/// Its old speed, behind a start.
Outcome<bool> RunningMotor::reach()
{
    const drive::MotorLimits &limits = m_subject.limits;
    const auto running = statusWithin(m_desk, lab::kRunsWithin, [](const drive::MotorStatus &it) {
        return it.state == MotorState::Running || drive::hasFault(it.state);
    });
    if (!running)
        return tl::make_unexpected(running.error());
    const auto isThere = [&](const drive::MotorStatus &it) {
        return it.state == MotorState::Running && lab::isNear(it.speedRpm, m_rpm, limits);
    };
    lab::Settling settling;
    const auto steady = [&](const drive::MotorStatus &it) {
        const TimePoint now(steady_clock::now().time_since_epoch());
        return settling.settled(isThere(it), now) || drive::hasFault(it.state);
    };
    const auto there = running->state == MotorState::Running
        ? statusWithin(m_desk, lab::kApproach + lab::kReachesWithin, steady)
        : running;
    if (!there)
        return tl::make_unexpected(there.error());
    if (!isThere(*there))
        return failure(kRefused,
            QStringLiteral("The motor did not come back to %1: %2.")
                .arg(rpmText(m_rpm), stateText(*there)));
    return true;
}

Outcome<std::optional<RunningMotor>> runningMotor(
    Desk &desk, const lab::Subject &subject, const std::vector<lab::Experiment> &wanted)
{
    using None = std::optional<RunningMotor>;
    const bool asItRuns = std::all_of(wanted.begin(), wanted.end(), [](const auto &one) {
        return lab::conditionsOf(one).beginning == lab::Beginning::AtSpeed;
    });
    if (asItRuns && !lab::inBothDirections(wanted))
        return None();
    const auto status = desk.talk.nextStatus(subject.motor);
    if (!status)
        return tl::make_unexpected(status.error());
    if (status->state != MotorState::Running)
        return None();
    const auto target = startTarget(desk);
    if (!target)
        return tl::make_unexpected(target.error());
    if (target->control != catalog::ControlMode::Speed || !target->rpm)
        return None();
    if (!lab::isNear(status->speedRpm, *target->rpm, subject.limits))
        return failure(kRefused,
            QStringLiteral("Not begun: the motor does not turn at its set-point of %1.")
                .arg(rpmText(*target->rpm)));
    const double most = desk.arguments.limits.maxSpeedRpm;
    if (most > 0.0 && std::abs(*target->rpm) > most)
        return failure(kRefused,
            QStringLiteral("Not begun: the motor turns at %1, and would not be brought back to "
                           "it: %2 are allowed.")
                .arg(rpmText(*target->rpm), rpmText(most)));
    const auto lost = lostReferences(desk, subject, wanted);
    if (!lost)
        return tl::make_unexpected(lost.error());
    if (!lost->isEmpty())
        return failure(kRefused,
            QStringLiteral("Not begun: %1 is not 0, and would be afterwards: bring it to 0 first.")
                .arg(*lost));
    return None(
        std::in_place, desk, subject, static_cast<int>(std::lround(*target->rpm)), target->ramp);
}

} // namespace cli
