#include "lab/step_runner.h"

#include "drive/values.h"

#include <algorithm>
#include <cmath>

namespace lab {

namespace {

using namespace std::chrono_literals;
using drive::MotorState;

constexpr Duration kAnswerWithin = 3s; ///< of what moves nothing
constexpr Duration kRunsWithin = 10s; ///< a start, with its alignment and its rev-up
constexpr Duration kReachesWithin = 5s; ///< after the ramp
constexpr Duration kRestsWithin = 5s; ///< after its stop
constexpr Duration kSteadyFor = 200ms; ///< a speed that only passes by is not reached
constexpr Duration kPolls = 20ms; ///< of bus and temperature
constexpr double kShareOfLink = 0.75; ///< for the samples; the rest is for commands and readings

/// Margins of the envelope; what they leave room for is in the comment of each.
constexpr double kOvershoot = 0.5; ///< of the step, to either side: loops that are being tuned overshoot
constexpr double kLeastMargin_rpm = 120.0; ///< noise of a sensorless speed
constexpr double kAboveBoard = 1.1; ///< of the greatest speed that a board tells: its own loop overshoots there
constexpr double kCurrentAboveBoard = 1.25; ///< its current loop does, too
constexpr double kBusRise = 1.1, kBusSag = 0.7;
constexpr double kHottest_c = 85.0;

std::string rpmText(double rpm) { return std::to_string(std::lround(rpm)) + " rpm"; }

std::string namesOf(const std::vector<std::string> &faults)
{
    std::string all;
    for (const std::string &name : faults)
        all += (all.empty() ? "" : ", ") + name;
    return all;
}

Watched watchedOf(const StepExperiment &experiment)
{
    const StepRegisters &registers = experiment.board.registers;
    return {experiment.plan.motor, registers.speed, registers.current, registers.bus, registers.temperature};
}

} // namespace

StepRunner::StepRunner(StepExperiment experiment)
    : m_experiment(std::move(experiment))
    , m_envelope(watchedOf(m_experiment))
{
}

void StepRunner::begin(TimePoint now)
{
    const StepBoard &board = m_experiment.board;
    if (const std::string why = objectionTo(m_experiment.plan, board.limits); !why.empty()) {
        m_outcome = {StepEnd::Refused, why, {}};
        return;
    }
    enter(Phase::Reading, kAnswerWithin, now);
    drive::Read read{board.setPoint};
    for (const drive::RegisterId id : {board.registers.bus, board.registers.temperature})
        if (id != 0)
            read.registers.push_back(id);
    ask(std::move(read), now);
}

void StepRunner::enter(Phase phase, Duration within, TimePoint now)
{
    m_phase = phase;
    m_until = now + within;
    m_settled = false;
}

void StepRunner::ask(decltype(drive::Wish::what) what, TimePoint now)
{
    m_waiting = ++m_lastWish;
    m_answered = false;
    m_wishes.push_back({.id = m_waiting,
        .what = std::move(what),
        .source = drive::Source::Script,
        .madeAt = now});
}

void StepRunner::ramp(int rpm, milliseconds duration, TimePoint now)
{
    m_asked_rpm = rpm;
    m_commanded = true;
    ask(drive::SpeedRamp{m_experiment.plan.motor, rpm, duration}, now);
}

std::vector<drive::Wish> StepRunner::takeWishes() { return std::exchange(m_wishes, {}); }

std::optional<double> StepRunner::shown(drive::RegisterId id) const
{
    const auto at = m_values.find(id);
    const auto number = at == m_values.end() ? std::nullopt : drive::asNumber(at->second);
    if (!number)
        return std::nullopt;
    return *number * m_experiment.board.catalog->readScale(id).factor;
}

void StepRunner::take(const drive::Event &event, TimePoint now)
{
    if (over())
        return;
    const auto broken = m_envelope.take(event, *m_experiment.board.catalog, now);
    if (broken && moves())
        return abort(*broken);
    if (const auto *ended = std::get_if<drive::Ended>(&event)) {
        onEnded(*ended, now);
    } else if (const auto *status = std::get_if<drive::MotorStatus>(&event)) {
        if (status->motor == m_experiment.plan.motor)
            onStatus(*status, now);
    } else if (const auto *read = std::get_if<drive::RegistersRead>(&event)) {
        for (const drive::Reading &reading : read->readings)
            if (reading.status == drive::ReadStatus::Ok)
                m_values[reading.id] = reading.value;
    } else if (const auto *link = std::get_if<drive::LinkChanged>(&event)) {
        // One that is out of step for a moment is bounded by the silence.
        const bool answers =
            link->state != drive::LinkState::Lost && link->state != drive::LinkState::Closed;
        if (!answers)
            lose("the link to the board was lost");
    }
    advance(now);
}

void StepRunner::onEnded(const drive::Ended &ended, TimePoint now)
{
    if (ended.id != m_waiting)
        return;
    m_waiting = 0;
    m_answered = ended.outcome == drive::Outcome::Ok;
    const bool mayHaveHappened = m_answered || ended.outcome == drive::Outcome::Unknown;
    if (m_asked_rpm && mayHaveHappened)
        m_target_rpm = *m_asked_rpm;
    m_asked_rpm.reset();
    m_stands = m_stands || (m_phase == Phase::Starting && !mayHaveHappened);
    if (m_answered) {
        if (m_phase == Phase::Stepping)
            m_until = now + m_experiment.plan.hold;
        return;
    }
    std::string why = ended.outcome == drive::Outcome::Unknown
        ? "the board's answer was lost"
        : ended.outcome == drive::Outcome::NotSent ? "it was not sent" : "the board refused it";
    if (!ended.reason.empty())
        why += " (" + ended.reason + ")";
    constexpr const char *kAsked[] = {"reading the motor's state", "recording its signals",
        "reading its bus voltage", "the first speed", "the start", "the way to the first speed", "a step",
        "the way back", "the old set-point", "reading the set-point", ""};
    giveUp(StepEnd::Refused, std::string(kAsked[static_cast<std::size_t>(m_phase)]) + ": " + why, now);
}

void StepRunner::onStatus(const drive::MotorStatus &status, TimePoint)
{
    m_status = status;
    if (!moves())
        return;
    if (status.state == MotorState::FaultNow || status.state == MotorState::FaultOver) {
        const auto &faults = status.faultsNow.empty() ? status.faultsPast : status.faultsNow;
        m_soFar = {StepEnd::Aborted, "the board reports a fault: " + namesOf(faults), {}};
        return finish();
    }
    const bool rests = status.state == MotorState::Idle || status.state == MotorState::Stopping;
    const bool mayRest =
        m_phase == Phase::Starting || (m_phase == Phase::Returning && !m_ran);
    if (rests && !mayRest)
        interrupt("something else stopped the motor");
}

void StepRunner::advance(TimePoint now)
{
    if (over())
        return;
    if (moves())
        if (const auto silent = m_envelope.silence(now))
            return abort(*silent);
    const bool late = now >= m_until;
    switch (m_phase) {
    case Phase::Reading:
        if (m_answered && m_status)
            return onRead(now);
        break;
    case Phase::Streaming:
        if (!m_answered)
            break;
        enter(Phase::Watching, kAnswerWithin, now);
        return ask(watch(), now);
    case Phase::Watching:
        if (!m_answered)
            break;
        if (m_ran)
            return approach(now);
        // What is asked for at rest is where the start goes: not by way of the old set-point.
        enter(Phase::Aiming, kAnswerWithin, now);
        return ramp(m_experiment.plan.fromRpm, m_experiment.plan.approach, now);
    case Phase::Aiming:
        if (!m_answered)
            break;
        m_envelope.set(startCaps(), now);
        enter(Phase::Starting, kRunsWithin, now);
        return ask(drive::Command{drive::MotorAction::Start, m_experiment.plan.motor}, now);
    case Phase::Starting:
        if (m_answered && m_status->state == MotorState::Running)
            return approach(now);
        break;
    case Phase::Approaching:
        if (m_answered && steadyAt(m_experiment.plan.fromRpm, now)) {
            m_phase = Phase::Stepping;
            return step(now);
        }
        break;
    case Phase::Stepping:
        if (!late)
            return;
        if (!m_answered)
            break;
        return m_steps == 2 * m_experiment.plan.repeat ? giveBack(now) : step(now);
    case Phase::Returning:
        if (!m_answered)
            break;
        if (m_ran ? steadyAt(m_before_rpm, now) : m_status->state == MotorState::Idle)
            return onReturned(now);
        break;
    case Phase::Restoring:
        if (!m_answered)
            break;
        enter(Phase::Comparing, kAnswerWithin, now);
        return ask(drive::Read{m_experiment.board.setPoint}, now);
    case Phase::Comparing:
        if (m_answered)
            return onCompared();
        break;
    case Phase::Over:
        return;
    }
    if (late)
        onLate(now);
}

/// What the phase waits for did not come.
void StepRunner::onLate(TimePoint now)
{
    switch (m_phase) {
    case Phase::Starting:
        return abort("the motor did not come to run within "
            + std::to_string(kRunsWithin / 1s) + " s");
    case Phase::Approaching:
        return giveUp(StepEnd::Refused,
            "the speed did not come to rest at " + rpmText(m_experiment.plan.fromRpm), now);
    case Phase::Returning:
        return abort(m_ran ? "the speed did not come back to " + rpmText(m_before_rpm)
                           : std::string("the motor was not seen to stop"));
    default:
        return giveUp(StepEnd::Refused, "no answer came in time", now);
    }
}

/// What the motor does decides whether anything may be asked of it.
void StepRunner::onRead(TimePoint now)
{
    const auto refuse = [this](const std::string &why) {
        m_soFar = {StepEnd::Refused, why, {}};
        finish();
    };
    m_ran = m_status->state == MotorState::Running;
    if (!m_ran && m_status->state != MotorState::Idle)
        return refuse("the motor neither runs nor rests: it is in " + m_status->stateName);
    const drive::StartTarget target = startTarget();
    if (target.control != drive::ControlMode::Speed || !target.rpm)
        return refuse("the motor is not in speed control, so a speed cannot be stepped");
    m_before_rpm = *target.rpm;
    // On its way, or held by the end of a ramp, it would be brought back to a speed that it did not have.
    if (m_ran && !near(m_status->speedRpm, m_before_rpm))
        return refuse("the motor does not turn at its set-point of " + rpmText(m_before_rpm));
    m_target_rpm = static_cast<int>(std::lround(*target.rpm));
    enter(Phase::Streaming, kAnswerWithin, now);
    ask(stream(), now);
}

drive::Stream StepRunner::stream() const
{
    const StepRegisters &registers = m_experiment.board.registers;
    drive::Stream stream;
    stream.fast = {registers.reference, registers.current, registers.speed};
    if (registers.angle != 0)
        stream.fast.push_back(registers.angle);
    stream.fastEvery = m_experiment.board.fastEvery(stream.fast.size(), kShareOfLink);
    return stream;
}

drive::Watch StepRunner::watch() const
{
    drive::Watch watch{.registers = {}, .period = kPolls};
    for (const drive::RegisterId id :
        {m_experiment.board.registers.bus, m_experiment.board.registers.temperature})
        if (id != 0)
            watch.registers.push_back(id);
    return watch;
}

/// From the first command to the last. A motor on its way to its speed passes 0 and the speed it had.
Caps StepRunner::caps() const
{
    const StepPlan &plan = m_experiment.plan;
    const drive::MotorLimits &limits = m_experiment.board.limits;
    const double from = plan.fromRpm, to = plan.toRpm;
    const double margin = std::max(kLeastMargin_rpm, kOvershoot * std::abs(to - from));
    const double other = m_ran ? m_before_rpm : 0.0;
    Caps caps;
    caps.leastRpm = std::min({from, to, other}) - margin;
    caps.mostRpm = std::max({from, to, other}) + margin;
    caps.leastRpm = std::max(caps.leastRpm, -allowedRpm());
    caps.mostRpm = std::min(caps.mostRpm, allowedRpm());
    caps.mostAmps = plan.maxAmps > 0.0 ? plan.maxAmps : limits.maxCurrentAmps * kCurrentAboveBoard;
    if (const auto bus = shown(m_experiment.board.registers.bus)) {
        caps.leastBus_v = *bus * kBusSag;
        caps.mostBus_v = *bus * kBusRise;
    }
    if (shown(m_experiment.board.registers.temperature).value_or(kHottest_c) < kHottest_c)
        caps.mostTemperature_c = kHottest_c;
    return caps;
}

/// How a board aligns its rotor and brings it up is its own matter.
Caps StepRunner::startCaps() const
{
    Caps wide = caps();
    wide.leastRpm = -allowedRpm();
    wide.mostRpm = allowedRpm();
    return wide;
}

/// Whatever the plan: what the board tells, and never more than the user allows.
double StepRunner::allowedRpm() const
{
    const double board = m_experiment.board.limits.maxSpeedRpm * kAboveBoard;
    const double user = m_experiment.plan.maxRpm;
    return user > 0.0 && board > 0.0 ? std::min(user, board) : std::max(user, board);
}

/// What set-points differ by in the board's digits is no difference.
double StepRunner::tolerated() const
{
    return std::max(1.0, m_experiment.board.limits.speedStepRpm);
}

void StepRunner::approach(TimePoint now)
{
    const StepPlan &plan = m_experiment.plan;
    m_envelope.set(caps(), now);
    enter(Phase::Approaching, plan.approach + kReachesWithin, now);
    ramp(plan.fromRpm, plan.approach, now);
}

void StepRunner::step(TimePoint now)
{
    const StepPlan &plan = m_experiment.plan;
    ++m_steps;
    m_until = now + plan.hold + kAnswerWithin; // the hold begins with the answer
    ramp(m_steps % 2 == 1 ? plan.toRpm : plan.fromRpm, 0ms, now);
}

/// The motor as it was: at its old speed, or at rest if this started it.
void StepRunner::giveBack(TimePoint now)
{
    const StepPlan &plan = m_experiment.plan;
    enter(Phase::Returning, m_ran ? plan.approach + kReachesWithin : kRestsWithin, now);
    if (m_ran)
        return ramp(static_cast<int>(std::lround(m_before_rpm)), plan.approach, now);
    Caps resting = caps(); // a board may record nothing while nothing is driven
    resting.silence = Duration::zero();
    m_envelope.set(resting, now);
    ask(drive::Command{drive::MotorAction::StopMotor, plan.motor}, now);
}

void StepRunner::onReturned(TimePoint now)
{
    if (m_ran) {
        enter(Phase::Comparing, kAnswerWithin, now);
        return ask(drive::Read{m_experiment.board.setPoint}, now);
    }
    restore(now);
}

/// Of the set-point, while the motor rests.
void StepRunner::restore(TimePoint now)
{
    enter(Phase::Restoring, kAnswerWithin, now);
    ramp(static_cast<int>(std::lround(m_before_rpm)), 0ms, now);
}

void StepRunner::onCompared()
{
    const drive::StartTarget target = startTarget();
    if (target.rpm && std::abs(*target.rpm - m_before_rpm) <= tolerated())
        m_target_rpm = static_cast<int>(std::lround(m_before_rpm));
    else
        m_target_rpm = static_cast<int>(std::lround(target.rpm.value_or(m_target_rpm)));
    finish();
}

/// Something was refused or did not happen: back, as far as anything was begun.
void StepRunner::giveUp(StepEnd end, const std::string &reason, TimePoint now)
{
    if (m_phase > Phase::Returning) { // all was measured; what is not as it was is said
        m_soFar.reason += (m_soFar.reason.empty() ? "" : "; ") + reason;
        return finish();
    }
    if (m_soFar.reason.empty())
        m_soFar = {end, reason, {}};
    if (!m_commanded)
        return finish();
    if (m_phase == Phase::Aiming || (m_phase == Phase::Starting && m_stands))
        return restore(now);
    if (m_phase == Phase::Returning || m_phase == Phase::Starting)
        return abort(reason);
    giveBack(now);
}

void StepRunner::abort(const std::string &reason)
{
    m_stop = true;
    const std::string first = m_soFar.reason.empty() ? std::string() : m_soFar.reason + "; then ";
    m_soFar = {StepEnd::Aborted, first + reason + "; every motor is being stopped", {}};
    finish();
}

void StepRunner::interrupt(const std::string &why)
{
    if (over())
        return;
    m_soFar = {StepEnd::Interrupted, why, {}};
    finish();
}

void StepRunner::lose(const std::string &why)
{
    if (over() || !moves())
        return interrupt(why);
    abort(why);
}

/// What is not as it was is said.
void StepRunner::finish()
{
    m_wishes.clear();
    m_phase = Phase::Over;
    const double now_rpm = m_asked_rpm.value_or(m_target_rpm); // on its way it may have been taken
    if (m_commanded && std::abs(now_rpm - m_before_rpm) > tolerated())
        m_soFar.reason += std::string(m_soFar.reason.empty() ? "" : "; ") + "the set-point "
            + (m_asked_rpm ? "may be " : "is ") + rpmText(now_rpm) + " now, it was "
            + rpmText(m_before_rpm);
    m_outcome = m_soFar;
}

bool StepRunner::near(std::optional<double> speed, double rpm) const
{
    constexpr double kDigits = 3.0, kShare = 0.03;
    return speed && std::abs(*speed - rpm) <= std::max(kDigits * tolerated(), kShare * std::abs(rpm));
}

drive::StartTarget StepRunner::startTarget() const
{
    const StepBoard &board = m_experiment.board;
    return drive::startTarget(*board.catalog, board.limits, m_experiment.plan.motor,
        [this](drive::RegisterId id) -> std::optional<catalog::Value> {
            const auto at = m_values.find(id);
            return at == m_values.end() ? std::nullopt : std::optional(at->second);
        });
}

/// The speed has been right for a while.
bool StepRunner::steadyAt(double rpm, TimePoint now)
{
    if (!near(m_envelope.rpm(), rpm)) {
        m_settled = false;
        return false;
    }
    if (!m_settled)
        m_settledAt = now;
    m_settled = true;
    return now - m_settledAt >= kSteadyFor;
}

std::optional<TimePoint> StepRunner::nextTimeout() const
{
    if (over())
        return std::nullopt;
    const auto silent = moves() ? m_envelope.silentAt() : std::nullopt;
    return silent ? std::min(m_until, *silent) : m_until;
}

} // namespace lab
