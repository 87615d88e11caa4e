#include "lab/runner.h"

#include "drive/values.h"
#include "lab/caps.h"
#include "lab/lent.h"
#include "motor/rev_up.h"

#include <algorithm>
#include <cmath>

namespace lab {

namespace {

using namespace std::chrono_literals;
using drive::MotorState;

constexpr Duration kAnswerWithin = 3s; ///< of what moves nothing
constexpr Duration kSwingsLeft = kReachesWithin - kSwingsAfter; ///< of it
constexpr int kMostTries = 4; ///< of what could not leave in time
constexpr const char *kStoppedByOthers = "something else stopped the motor";
constexpr const char *kNotSeenToStop = "the motor was not seen to stop";
/// All answers to a plan's steps, beyond its length: 25 ms each for 200 of them. Speeds that are reached at once leave
/// 10 s more.
constexpr Duration kAnswersTake = 5s;

/// Of what only the board tells; the other margins are in lab/caps.h.
constexpr double kBusRise = 1.1, kBusSag = 0.7;
constexpr double kHottest_c = 85.0;
constexpr double kNoTemperature_c = 200.0; ///< a board that tells as much measures none

std::string rpmText(double rpm) { return std::to_string(std::lround(rpm)) + " rpm"; }

std::string celsiusText(double celsius)
{
    return std::to_string(std::lround(celsius)) + " \u00b0C";
}

std::string namesOf(const std::vector<std::string> &faults)
{
    std::string all;
    for (const std::string &name : faults)
        all += (all.empty() ? "" : ", ") + name;
    return all;
}

std::string faultText(const drive::MotorStatus &status)
{
    return "the board reports a fault: "
        + namesOf(status.faultsNow.empty() ? status.faultsPast : status.faultsNow);
}

std::string noRestText(const drive::MotorStatus &status)
{
    return drive::hasFault(status.state) ? faultText(status) : "the motor was started meanwhile";
}

/// As far as a sensor sees it.
bool stands(const drive::MotorStatus &status, const Experiment &experiment)
{
    const Subject &subject = experiment.subject;
    return subject.seesRotor() && isStill(status.speedRpm, allowedRpm(experiment), subject.limits);
}

/// The same: a start would brake it onto the bus.
bool turnsBack(const drive::MotorStatus &status, const Experiment &experiment)
{
    return experiment.subject.seesRotor()
        && status.speedRpm.value_or(0.0) * conditionsOf(experiment).firstRpm < 0.0;
}

/// A start-up as an experiment at rest writes it. No motor that starts without a sensor has such a one of its own.
bool turnsNothing(const catalog::Value &startUp)
{
    const auto *bytes = std::get_if<Bytes>(&startUp);
    const auto stages = motor::revUpOfBytes(bytes != nullptr ? ByteView(*bytes) : ByteView());
    return stages
        && std::all_of(stages->begin(), stages->end(),
            [](const motor::RevUpStage &stage) { return stage.speed_rpm == 0; });
}

/// By the drive, or by its board.
std::string whyNot(const drive::Ended &ended)
{
    const std::string why = ended.outcome == drive::Outcome::Unknown ? "the board's answer was lost"
        : ended.outcome == drive::Outcome::NotSent                   ? "it was not sent"
                                                                     : "it was refused";
    return ended.reason.empty() ? why : why + " (" + ended.reason + ")";
}

using Values = std::map<drive::RegisterId, catalog::Value>;

bool areAsBefore(const std::vector<drive::RegisterWrite> &before, const Values &now)
{
    return std::ranges::all_of(before, [&now](const drive::RegisterWrite &one) {
        const auto at = now.find(one.id);
        return at != now.end() && drive::sameValue(one.value, at->second);
    });
}

std::vector<Lent> lentOf(const std::vector<drive::RegisterWrite> &before, const Subject &subject)
{
    std::vector<Lent> lent;
    lent.reserve(before.size());
    for (const drive::RegisterWrite &one : before)
        lent.push_back({subject.nameOf(one.id), typedText(one.value)});
    return lent;
}

/// What would not be bounded although the board tells it, or would break its bound at once.
std::string unboundedOf(
    const Subject &subject, std::optional<double> bus_v, std::optional<double> stage_c)
{
    const drive::RegisterId bus = subject.registers.bus;
    if (bus != 0 && !bus_v)
        return "the board does not give " + subject.nameOf(bus)
            + ", and without it nothing bounds its bus";
    if (stage_c && *stage_c >= kHottest_c && *stage_c < kNoTemperature_c)
        return "the board is at " + celsiusText(*stage_c) + ", and " + celsiusText(kHottest_c)
            + " end an experiment: let it cool down first";
    return {};
}

Watched watchedOf(const Experiment &experiment)
{
    const Registers &registers = experiment.subject.registers;
    return {experiment.subject.motor, registers.speed, registers.current, registers.currentD,
        registers.bus, registers.temperature, registers.angle, experiment.subject.limits.polePairs,
        experiment.subject.polled};
}

} // namespace

Runner::Runner(Experiment experiment)
    : m_experiment(std::move(experiment))
    , m_conditions(conditionsOf(m_experiment))
    , m_course(courseOf(m_experiment))
    , m_envelope(watchedOf(m_experiment))
{
}

void Runner::begin(TimePoint now, std::optional<TimePoint> ranAt)
{
    m_ranAt = ranAt;
    const Subject &subject = m_experiment.subject;
    if (const std::string why = objectionTo(m_experiment); !why.empty()) {
        m_outcome = {End::Refused, why, {}};
        return;
    }
    // No wish of an experiment before this one has the same: a wish takes longer than a nanosecond.
    m_lastWish = kFirstWish + static_cast<drive::WishId>(now.time_since_epoch().count());
    enter(Phase::Reading, kAnswerWithin, now);
    drive::Read read{subject.setPoint};
    for (const drive::RegisterId id : {subject.registers.bus, subject.registers.temperature})
        if (id != 0)
            read.registers.push_back(id);
    for (const drive::RegisterWrite &lent : m_conditions.lent)
        read.registers.push_back(lent.id);
    for (const drive::RegisterId id : m_conditions.zeroBefore)
        if (id != 0)
            read.registers.push_back(id);
    read.registers.insert(read.registers.end(), subject.way.begin(), subject.way.end());
    ask(std::move(read), now);
}

void Runner::enter(Phase phase, Duration within, TimePoint now)
{
    m_phase = phase;
    m_until = now + within;
    m_settling = {};
}

void Runner::ask(Ask what, TimePoint now)
{
    if (const auto *ramp = std::get_if<drive::SpeedRamp>(&what)) {
        m_asked_rpm = ramp->rpm;
        m_wayWritten = !m_way.empty();
    }
    const auto *currents = std::get_if<drive::CurrentReference>(&what);
    if (currents != nullptr)
        m_currents = *currents;
    const bool position = std::holds_alternative<drive::PositionRamp>(what);
    const bool torque =
        position || currents != nullptr || std::holds_alternative<drive::TorqueRamp>(what);
    m_byTorque = m_byTorque || torque;
    m_byPosition = torque ? position : m_byPosition;
    m_commanded = m_commanded || torque || m_asked_rpm;
    if (const auto *read = std::get_if<drive::Read>(&what))
        for (const drive::RegisterId id : read->registers)
            m_values.erase(id); // what is not read now is not known
    m_answered = false;
    m_asked = std::move(what);
    again(now);
}

/// What was asked for last.
void Runner::again(TimePoint now)
{
    m_waiting = ++m_lastWish;
    m_wishes.push_back(
        {.id = m_waiting, .what = m_asked, .source = drive::Source::Script, .madeAt = now});
}

void Runner::ramp(int rpm, milliseconds duration, TimePoint now)
{
    ask(drive::SpeedRamp{m_experiment.subject.motor, rpm, duration}, now);
}

std::vector<drive::Wish> Runner::takeWishes() { return std::exchange(m_wishes, {}); }

std::optional<double> Runner::shown(drive::RegisterId id) const
{
    const auto at = m_values.find(id);
    const auto number = at == m_values.end() ? std::nullopt : drive::asNumber(at->second);
    if (!number || !std::isfinite(*number))
        return std::nullopt;
    return *number * m_experiment.subject.catalog->readScale(id).factor;
}

void Runner::accept(const drive::Event &event, TimePoint now)
{
    if (over())
        return;
    const auto broken = m_envelope.accept(event, *m_experiment.subject.catalog, now);
    if (broken && moves())
        return abort(*broken + wrongWay());
    if (const auto *ended = std::get_if<drive::Ended>(&event)) {
        onEnded(*ended, now);
    } else if (const auto *status = std::get_if<drive::MotorStatus>(&event)) {
        if (status->motor == m_experiment.subject.motor)
            onStatus(*status, now);
    } else if (const auto *read = std::get_if<drive::RegistersRead>(&event)) {
        for (const drive::Reading &reading : read->readings)
            if (reading.status == drive::ReadStatus::Ok)
                m_values[reading.id] = reading.value;
    } else if (const auto *travel = std::get_if<drive::CyclicSetPointsChanged>(&event)) {
        m_travels = travel->on;
    } else if (const auto *link = std::get_if<drive::LinkChanged>(&event)) {
        // One that is out of step for a moment is bounded by the silence.
        const bool answers =
            link->state != drive::LinkState::Lost && link->state != drive::LinkState::Closed;
        if (!answers)
            lose("the link to the board was lost");
    }
    advance(now);
}

/// A motor that is slowed down gives its energy to the bus. Only what was taken before is known to be taken. Before its
/// speed came for the first time, one that runs has that of its set-point.
milliseconds Runner::wayTo(double rpm) const
{
    const double now_rpm = m_envelope.rpm().value_or(m_ran ? m_before_rpm : 0.0);
    const double kept = now_rpm * rpm > 0.0 ? rpm * rpm : 0.0;
    const bool gently = m_ran && now_rpm * now_rpm - kept > m_braked;
    return gently ? m_conditions.gently() : m_conditions.approach;
}

void Runner::onEnded(const drive::Ended &ended, TimePoint now)
{
    if (ended.id != m_waiting)
        return;
    m_waiting = 0;
    const bool mayBeRepeated = ended.reason == drive::kTooLate || ended.reason == drive::kNoAnswer;
    if (ended.outcome == drive::Outcome::NotSent && mayBeRepeated && ++m_tries < kMostTries)
        return again(now); // this computer or the line stood still, and nothing has left
    m_tries = 0;
    m_answered = ended.outcome == drive::Outcome::Ok;
    m_answeredAt = now;
    const bool mayHaveHappened = m_answered || ended.outcome == drive::Outcome::Unknown;
    if (std::holds_alternative<drive::SpeedRamp>(m_asked)) { // a fault may end it unanswered
        if (m_asked_rpm && mayHaveHappened)
            m_target_rpm = *m_asked_rpm;
        m_byTorque = m_byTorque && !m_answered;
        m_asked_rpm.reset();
    }
    if (m_phase == Phase::Travelling && ended.outcome == drive::Outcome::Unknown)
        m_travels = true; // or may
    if (const auto *travel = std::get_if<drive::CyclicSetPoints>(&m_asked); travel != nullptr)
        m_travels = m_travels && (travel->on || !m_answered);
    m_stands = m_stands || (m_phase == Phase::Starting && !mayHaveHappened);
    if (m_answered)
        return;
    constexpr const char *kAsked[] = {"reading the motor's state", "recording its signals",
        "reading its bus voltage", "", "set-points with every exchange", "what it writes",
        "what the start goes to", "the start", "the way to the first speed", "a step of it",
        "the way back", "what was there before", "reading what is there afterwards", ""};
    const std::string what = kAsked[static_cast<std::size_t>(m_phase)];
    giveUp(End::Refused, what + ": " + whyNot(ended), now);
}

void Runner::onStatus(const drive::MotorStatus &status, TimePoint now)
{
    m_status = status;
    // A board may take a start and answer as if it had not.
    const bool drives = status.state == MotorState::Starting || status.state == MotorState::Running;
    if (m_stands && drives && !m_ran)
        return abort("the motor was started all the same");
    if (!moves())
        return;
    if (drive::hasFault(status.state)) {
        // Of its own start, which an experiment only asks for.
        const bool early = !m_ran && (m_phase == Phase::Starting || m_phase == Phase::Approaching);
        return endButReturn(End::Aborted,
            (early ? "the motor did not get to its first speed: " : "") + faultText(status), now);
    }
    const bool rests = status.state == MotorState::Idle || status.state == MotorState::Stopping;
    const bool mayRest = m_phase == Phase::Starting || (m_phase == Phase::Returning && !m_ran);
    if (rests && !mayRest)
        return needsEnvelope() ? interrupt(kStoppedByOthers)
                               : endButReturn(End::Interrupted, kStoppedByOthers, now);
    const bool atWork = m_phase == Phase::Working;
    if (m_conditions.beginning == Beginning::WhileStarting && atWork
        && status.state == MotorState::Running)
        giveUp(End::Refused, "the start-up went on to turn the motor", now);
}

void Runner::advance(TimePoint now)
{
    if (over())
        return;
    if (moves())
        if (const auto silent = m_envelope.silence(now))
            return abort(*silent);
    if (moves() && m_deadline && now >= *m_deadline)
        return abort("it was not over within "
            + std::to_string((lengthOf(m_experiment) + kAnswersTake) / 1s) + " s");
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
        return ask(watchOf(m_experiment), now);
    case Phase::Watching:
        if (!m_answered)
            break;
        return m_ran ? approach(now) : coast(now);
    case Phase::Coasting:
        if (m_status->state != MotorState::Idle)
            return giveUp(End::Refused, noRestText(*m_status), now);
        if (stands(*m_status, m_experiment) || (late && !turnsBack(*m_status, m_experiment)))
            return lend(now);
        break;
    case Phase::Travelling:
        if (m_answered)
            return lend(now);
        break;
    case Phase::Lending:
        if (m_answered)
            return aim(now);
        break;
    case Phase::Aiming:
        if (m_answered)
            return start(now);
        break;
    case Phase::Starting:
        if (m_answered)
            onStarted(now);
        if (m_phase != Phase::Starting)
            return;
        break;
    case Phase::Approaching:
        if (const auto amps = m_envelope.amps(); amps && now >= m_until - kReachesWithin) {
            m_ampSum += *amps;
            ++m_ampCount;
        }
        if (m_answered && (steadyAt(m_conditions.firstRpm, now) || swingsThrough(now))) {
            m_phase = Phase::Working;
            m_envelope.set(courseCaps(), now);
            return work(now);
        }
        break;
    case Phase::Working:
        if (m_answered || !late)
            return work(now);
        break;
    case Phase::Returning:
        if (!m_answered)
            break;
        if (m_ran && m_byTorque)
            return catchSpeed(now);
        if (m_ran && std::lround(m_target_rpm) != std::lround(m_before_rpm))
            return ramp(static_cast<int>(std::lround(m_before_rpm)), wayTo(m_before_rpm), now);
        if (m_ran ? steadyAt(m_before_rpm, now) || (m_swings && hadItsTime(now))
                  : m_status->state == MotorState::Idle)
            return restore(now);
        break;
    case Phase::Restoring:
        if (m_answered && (!m_cut || m_restores.empty() || drive::rests(m_status->state)))
            return restoreNext(now);
        break;
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

/// What a speed beyond its bounds means for a motor that was started and turns backward on its way to the first one.
std::string Runner::wrongWay() const
{
    const double rpm = m_envelope.rpm().value_or(0.0);
    const Caps bounds = caps();
    const bool backward =
        rpm * m_conditions.firstRpm < 0.0 && (rpm < bounds.leastRpm || rpm > bounds.mostRpm);
    if (m_phase != Phase::Approaching || m_ran || !m_experiment.subject.seesRotor() || !backward)
        return {};
    return ", and the wrong way: its sensor may be aligned wrongly, or two phases exchanged";
}

/// What the phase waits for did not come.
void Runner::onLate(TimePoint now)
{
    switch (m_phase) {
    case Phase::Starting:
        return abort(
            "the motor did not come to run within " + std::to_string(kRunsWithin / 1s) + " s");
    case Phase::Approaching:
        m_soFar.swings = m_soFar.reason.empty();
        return giveUp(End::Refused,
            "the speed did not come to rest at " + rpmText(m_conditions.firstRpm), now);
    case Phase::Returning:
        return abort(m_ran ? "the speed did not come back to " + rpmText(m_before_rpm)
                           : std::string(kNotSeenToStop));
    case Phase::Coasting:
        return giveUp(End::Refused, "the motor still turns the other way", now);
    default:
        return giveUp(
            End::Refused, m_cut && m_answered ? kNotSeenToStop : "no answer came in time", now);
    }
}

/// What the motor does decides whether anything may be asked of it.
void Runner::onRead(TimePoint now)
{
    const auto refuse = [this](const std::string &why) {
        m_soFar = {End::Refused, why, {}};
        finish();
    };
    m_ran = m_status->state == MotorState::Running;
    if (!m_ran && m_status->state != MotorState::Idle)
        return refuse("the motor neither runs nor rests: it is in " + m_status->stateName
            + (drive::hasFault(m_status->state) ? " ("
                        + namesOf(m_status->faultsPast.empty() ? m_status->faultsNow
                                                               : m_status->faultsPast)
                        + "): acknowledge the fault first"
                                                : ""));
    const drive::StartTarget target = startTarget();
    if (const std::string why = objectionWhileTurning(m_experiment, target.rpm.value_or(0.0));
        m_ran && !why.empty())
        return refuse(why);
    for (const drive::RegisterWrite &lent : m_conditions.lent) {
        const auto old = m_values.find(lent.id);
        if (old == m_values.end())
            return refuse("the board does not give " + m_experiment.subject.nameOf(lent.id)
                + ", which would be written");
        if (lent.id == m_experiment.subject.registers.startUp && turnsNothing(old->second))
            return refuse(m_experiment.subject.nameOf(lent.id)
                + " has no stage with a speed, as an experiment leaves it that was ended early: "
                  "write the motor's own stages first");
        m_old.push_back({lent.id, old->second});
    }
    if (target.control != catalog::ControlMode::Speed || !std::isfinite(target.rpm.value_or(NAN)))
        return refuse("the motor is not in speed control: ask for a speed first");
    for (const drive::RegisterId id : m_experiment.subject.way)
        if (const auto old = m_values.find(id); old != m_values.end())
            m_way.push_back({id, old->second});
    m_before_rpm = *target.rpm;
    m_beforeRamp = target.ramp.value_or(0ms);
    m_beforeShown_rpm = shown(m_experiment.subject.registers.speedReference);
    m_before_v = shown(m_experiment.subject.registers.bus);
    m_before_c = shown(m_experiment.subject.registers.temperature);
    if (const std::string why = unboundedOf(m_experiment.subject, m_before_v, m_before_c);
        !why.empty())
        return refuse(why);
    // On its way, or held by the end of a ramp, it would be brought back to a speed that it did not have.
    if (m_ran && !isNear(m_status->speedRpm, m_before_rpm, m_experiment.subject.limits))
        return refuse("the motor does not turn at its set-point of " + rpmText(m_before_rpm));
    m_target_rpm = m_before_rpm;
    for (const drive::RegisterId id : m_conditions.zeroBefore)
        if (m_ran && flows(shown(id).value_or(0.0), m_experiment.subject.limits))
            return refuse(m_experiment.subject.nameOf(id)
                + " is not 0, and would be afterwards: bring it to 0 first");
    if (m_experiment.subject.polled) {
        enter(Phase::Watching, kAnswerWithin, now);
        return ask(watchOf(m_experiment), now);
    }
    enter(Phase::Streaming, kAnswerWithin, now);
    ask(streamOf(m_experiment), now);
}

/// What the bus may have been: boards cut 23.99 V down to 23.
double Runner::mostBefore_v() const
{
    const drive::RegisterId bus = m_experiment.subject.registers.bus;
    return *m_before_v + m_experiment.subject.catalog->readScale(bus).factor;
}

/// From the first command to the last.
Caps Runner::caps() const
{
    Caps caps = capsOf(m_experiment, m_ran ? m_before_rpm : 0.0);
    if (m_before_v) {
        caps.leastBus_v = *m_before_v * kBusSag;
        caps.mostBus_v = mostBefore_v() * kBusRise;
    }
    if (m_before_c && *m_before_c < kNoTemperature_c)
        caps.mostTemperature_c = kHottest_c;
    return caps;
}

/// By what was read since the last answer: what was asked for before has no part in it any more.
std::optional<double> Runner::busRise() const
{
    const auto now_v = m_envelope.busSince(m_answeredAt);
    if (!m_before_v || !now_v)
        return std::nullopt;
    return (*now_v / mostBefore_v() - 1.0) / (kBusRise - 1.0);
}

/// How a board aligns its rotor and brings it up is its own matter.
Caps Runner::startCaps() const
{
    Caps wide = caps();
    wide.mostRpm = allowedRpm(m_experiment);
    wide.leastRpm = -wide.mostRpm;
    return wide;
}

/// Where the plan goes, and where an observer still sees the rotor.
Caps Runner::courseCaps() const
{
    Caps narrow = caps();
    const double observed = m_experiment.subject.leastObservedRpm(m_conditions.user.maxSpeedRpm);
    if (observed > 0.0 && m_conditions.leastRpm > 0.0)
        narrow.leastRpm = std::max(observed, m_conditions.leastRpm - m_conditions.margin_rpm);
    if (observed > 0.0 && m_conditions.mostRpm < 0.0)
        narrow.mostRpm = std::min(-observed, m_conditions.mostRpm + m_conditions.margin_rpm);
    return narrow;
}

void Runner::coast(TimePoint now)
{
    const Duration unseen =
        std::max(Duration::zero(), m_ranAt.value_or(now - kCoastsUnseen) + kCoastsUnseen - now);
    enter(Phase::Coasting, m_experiment.subject.seesRotor() ? kCoastsSeen : unseen, now);
    advance(now);
}

void Runner::lend(TimePoint now)
{
    if (m_conditions.travels && m_phase == Phase::Coasting) {
        enter(Phase::Travelling, kAnswerWithin, now);
        return ask(drive::CyclicSetPoints{true}, now);
    }
    if (m_conditions.lent.empty())
        return aim(now);
    enter(Phase::Lending, kAnswerWithin, now);
    m_lent = true;
    ask(drive::Write{m_conditions.lent, drive::Reach::Parameters}, now);
}

/// What is asked for at rest is where the start goes: not by way of the old set-point.
void Runner::aim(TimePoint now)
{
    if (m_conditions.beginning == Beginning::WhileStarting)
        return start(now);
    enter(Phase::Aiming, kAnswerWithin, now);
    if (m_conditions.beginning == Beginning::AtRest)
        return ask(drive::CurrentReference{m_experiment.subject.motor, 0.0, 0.0}, now);
    ramp(m_conditions.firstRpm, m_conditions.approach, now);
}

void Runner::start(TimePoint now)
{
    m_envelope.set(startCaps(), now);
    enter(Phase::Starting, kRunsWithin, now);
    ask(drive::Command{drive::MotorAction::Start, m_experiment.subject.motor}, now);
    m_commanded = true;
}

void Runner::onStarted(TimePoint now)
{
    const bool early = m_conditions.beginning == Beginning::WhileStarting;
    if (m_status->state != (early ? MotorState::Starting : MotorState::Running))
        return;
    if (m_conditions.beginning == Beginning::AtSpeed)
        return approach(now);
    m_envelope.set(early ? startCaps() : caps(), now);
    m_deadline = now + lengthOf(m_experiment) + kAnswersTake;
    m_phase = Phase::Working;
    work(now);
}

void Runner::approach(TimePoint now)
{
    m_envelope.set(caps(), now);
    m_deadline = now + lengthOf(m_experiment) + kAnswersTake;
    const milliseconds way = wayTo(m_conditions.firstRpm);
    enter(Phase::Approaching, way + kReachesWithin, now);
    ramp(m_conditions.firstRpm, way, now);
}

void Runner::work(TimePoint now)
{
    const auto amps =
        m_swings ? std::optional(m_ampSum / std::max(1, m_ampCount)) : m_envelope.amps();
    if (auto what = m_course->next({now, m_envelope.rpm(), amps, m_answered,
            shown(m_experiment.subject.registers.position), busRise()})) {
        m_until = now + kAnswerWithin;
        const auto *to = std::get_if<drive::SpeedRamp>(&*what);
        const double rpm = m_envelope.rpm().value_or(0.0);
        if (to != nullptr && to->duration <= m_conditions.approach) // slower ones show nothing
            m_braked = std::max(m_braked, rpm * rpm - double(to->rpm) * to->rpm);
        return ask(std::move(*what), now);
    }
    if (const std::string why = m_course->problem(); !why.empty())
        return giveUp(End::Refused, why, now);
    if (m_course->over())
        return giveBack(now);
    if (m_answered)
        m_until = m_course->due();
}

/// The motor as it was: at its old speed, or at rest if this started it.
void Runner::giveBack(TimePoint now)
{
    const milliseconds way = wayTo(m_before_rpm);
    enter(Phase::Returning, m_ran ? way + kReachesWithin : kRestsWithin, now);
    if (m_ran) {
        m_envelope.set(caps(), now);
        if (m_currents.idAmps == 0.0 && m_byTorque)
            return catchSpeed(now);
        if (m_currents.idAmps == 0.0)
            return ramp(static_cast<int>(std::lround(m_before_rpm)), way, now);
        m_currents.idAmps = 0.0; // speed control would keep it
        return ask(m_currents, now);
    }
    Caps resting = caps(); // a board may record nothing while nothing is driven
    resting.silence = Duration::zero();
    m_envelope.set(resting, now);
    ask(drive::Command{drive::MotorAction::StopMotor, m_experiment.subject.motor}, now);
}

/// Firmware keeps the speed reference of before the torque, and a ramp begins there: so first to the speed that it has.
void Runner::catchSpeed(TimePoint now)
{
    const auto has = m_envelope.rpm();
    if (!has) // a step to the old speed would be worse
        return ramp(static_cast<int>(std::lround(m_before_rpm)), wayTo(m_before_rpm), now);
    const double allowed = allowedRpm(m_experiment);
    const double rpm = std::clamp(*has, -allowed, allowed);
    ramp(static_cast<int>(std::lround(rpm)), milliseconds(0), now);
}

/// Of what was written: while the motor rests, or turns as before. A start goes its way in the time of the last ramp.
void Runner::restore(TimePoint now)
{
    if (m_travels)
        m_restores.push_back(drive::CyclicSetPoints{false});
    if (m_lent)
        m_restores.push_back(drive::Write{m_old, drive::Reach::Parameters});
    if (m_conditions.beginning != Beginning::WhileStarting)
        m_restores.push_back(drive::SpeedRamp{
            m_experiment.subject.motor, static_cast<int>(std::lround(m_before_rpm)), m_beforeRamp});
    if (m_wayWritten)
        m_restores.push_back(drive::Write{m_way, drive::Reach::References});
    restoreNext(now);
}

/// It is over, and armed still: what was borrowed goes back as soon as the motor rests. The set-point does not, which
/// only a fresh act changes behind a fault.
void Runner::endButReturn(End end, const std::string &why, TimePoint now)
{
    m_soFar = {end, why, {}};
    restSetPoints();
    if (!m_lent)
        return finish();
    m_cut = true;
    m_wishes.clear();
    m_waiting = 0;
    m_answered = true;
    m_restores.push_back(drive::Write{m_old, drive::Reach::Parameters});
    enter(Phase::Restoring, kRestsWithin, now);
}

void Runner::restoreNext(TimePoint now)
{
    if (m_restores.empty())
        return compare(now);
    enter(Phase::Restoring, kAnswerWithin, now);
    Ask next = std::move(m_restores.front());
    m_restores.pop_front();
    ask(std::move(next), now);
}

void Runner::compare(TimePoint now)
{
    enter(Phase::Comparing, kAnswerWithin, now);
    drive::Read read{m_experiment.subject.setPoint};
    for (const auto *all : {&m_old, &m_way})
        for (const drive::RegisterWrite &old : *all)
            read.registers.push_back(old.id);
    ask(std::move(read), now);
}

/// The set-point of before, asked for at rest, is kept for the next start, and no reference until then. Only a motion
/// would bring that back.
std::optional<ShownReference> Runner::shownReference() const
{
    const drive::RegisterId id = m_experiment.subject.registers.speedReference;
    const auto now_rpm = shown(id);
    if (m_ran || !m_beforeShown_rpm || !now_rpm)
        return std::nullopt;
    return ShownReference{m_experiment.subject.nameOf(id), *m_beforeShown_rpm, *now_rpm};
}

void Runner::onCompared()
{
    const drive::StartTarget target = startTarget();
    m_byPosition = m_byPosition && target.control == catalog::ControlMode::Other;
    m_byTorque = m_byPosition || target.control == catalog::ControlMode::Torque;
    if (target.rpm)
        m_asked_rpm.reset();
    m_target_rpm = target.rpm.value_or(m_target_rpm);
    m_lent = m_lent && !areAsBefore(m_old, m_values);
    m_wayWritten = m_wayWritten && !areAsBefore(m_way, m_values);
    m_soFar.shows = shownReference();
    finish();
}

/// Something was refused or did not happen: back, as far as anything was begun.
void Runner::giveUp(End end, const std::string &reason, TimePoint now)
{
    if (m_phase > Phase::Returning) { // all was measured; what is not as it was is said
        addReason(m_soFar, reason);
        return finish();
    }
    if (m_soFar.reason.empty()) {
        m_soFar.end = end;
        m_soFar.reason = reason;
    }
    if (!m_commanded && !m_lent && !m_travels)
        return finish();
    if (m_phase == Phase::Travelling || m_phase == Phase::Lending || m_phase == Phase::Aiming
        || (m_phase == Phase::Starting && m_stands))
        return restore(now);
    if (m_phase == Phase::Returning || m_phase == Phase::Starting)
        return abort(reason);
    giveBack(now);
}

void Runner::abort(const std::string &reason, const char *stopping)
{
    m_stop = true;
    const std::string first = m_soFar.reason.empty() ? std::string() : m_soFar.reason + "; then ";
    m_soFar = {End::Aborted, first + reason + "; " + stopping, {}};
    restSetPoints();
    finish();
}

void Runner::interrupt(const std::string &why)
{
    if (over())
        return;
    m_stop = needsEnvelope();
    if (m_stop)
        restSetPoints();
    cut(m_stop ? why + "; " + kStopping : why);
}

/// A Stop, and a fault, make those 0 that leave with every exchange.
void Runner::restSetPoints()
{
    if (!m_travels)
        return;
    m_target_rpm = 0;
    m_asked_rpm.reset();
}

/// What ended it first is kept.
void Runner::cut(const std::string &why)
{
    if (m_cut)
        addReason(m_soFar, "then " + why);
    else
        m_soFar = {End::Interrupted, why, {}};
    finish();
}

void Runner::stopped()
{
    if (over())
        return;
    restSetPoints();
    cut("every motor was stopped");
}

/// A torque accelerates the rotor until something takes it away; a start-up that was to turn nothing goes on by itself,
/// to the set-point of before.
bool Runner::needsEnvelope() const
{
    return moves() && (m_byTorque || m_conditions.beginning == Beginning::WhileStarting);
}

void Runner::disarm()
{
    const bool drives = moves() && m_phase != Phase::Returning && !m_ran && !needsEnvelope();
    interrupt(std::string("the drive was disarmed")
        + (drives ? ", and the motor that was started is driven on" : ""));
}

void Runner::lose(const std::string &why)
{
    if (over())
        return;
    if (moves())
        abort(why, "a Stop goes out as soon as the board is reached");
    else
        interrupt(why);
    if (!m_cut)
        m_outcome->end = End::Lost;
}

/// What is not as it was is said.
void Runner::finish()
{
    const bool mayTravel = m_phase == Phase::Travelling && m_waiting != 0;
    m_wishes.clear();
    m_phase = Phase::Over;
    const auto say = [this](const std::string &what) {
        addReason(m_soFar, what);
        m_soFar.leaves = true;
    };
    const auto isOld = [this](double rpm) {
        return std::abs(rpm - m_before_rpm) <= toleratedRpm(m_experiment.subject.limits);
    };
    // What is on its way may have been taken, and may not.
    std::string now;
    if (m_asked_rpm && !isOld(*m_asked_rpm))
        now = rpmText(*m_asked_rpm);
    if (!isOld(m_target_rpm) && rpmText(m_target_rpm) != now)
        now += (now.empty() ? "" : " or ") + rpmText(m_target_rpm);
    if (m_commanded && !now.empty())
        say(std::string("the set-point ") + (m_asked_rpm ? "may be " : "is ") + now
            + " now, it was " + rpmText(m_before_rpm));
    std::vector<drive::RegisterWrite> left = m_lent ? m_old : std::vector<drive::RegisterWrite>();
    if (m_wayWritten)
        left.insert(left.end(), m_way.begin(), m_way.end());
    for (const std::string &text : leftTexts(lentOf(left, m_experiment.subject)))
        say(text);
    if (m_travels)
        say("set-points leave with every exchange still");
    else if (mayTravel)
        say("set-points may leave with every exchange now");
    if (m_byTorque)
        say(std::string("the motor ") + (m_waiting != 0 ? "may be" : "is") + " in "
            + (m_byPosition ? "position" : "torque") + " control now, it was in speed control");
    if (m_soFar.leaves)
        m_soFar.shows.reset(); // a start goes elsewhere, too, or may
    m_outcome = m_soFar;
}

drive::StartTarget Runner::startTarget() const
{
    const Subject &subject = m_experiment.subject;
    return drive::startTarget(*subject.catalog, subject.limits, m_experiment.subject.motor,
        [this](drive::RegisterId id) -> std::optional<catalog::Value> {
            const auto at = m_values.find(id);
            return at == m_values.end() ? std::nullopt : std::optional(at->second);
        });
}

/// The speed has been right for a while.
bool Runner::steadyAt(double rpm, TimePoint now)
{
    return m_settling.settled(isNear(m_envelope.rpm(), rpm, m_experiment.subject.limits), now);
}

/// A speed that has not come to rest by now swings.
bool Runner::hadItsTime(TimePoint now) const { return now >= m_until - kSwingsLeft; }

/// It did not come to rest, is where the course goes, and the course does not need more.
bool Runner::swingsThrough(TimePoint now)
{
    const double rpm = m_envelope.rpm().value_or(0.0);
    m_swings = !m_conditions.steady && hadItsTime(now) && rpm >= m_conditions.leastRpm
        && rpm <= m_conditions.mostRpm;
    return m_swings;
}

std::optional<TimePoint> Runner::nextTimeout() const
{
    if (over())
        return std::nullopt;
    TimePoint next = m_until;
    if (moves())
        for (const auto &ends : {m_envelope.silentAt(), m_deadline})
            next = std::min(next, ends.value_or(next));
    return next;
}

} // namespace lab
