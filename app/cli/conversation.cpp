#include "conversation.h"

#include "commands.h"
#include "drive/board_facts.h"
#include "drive/motion_limits.h"
#include "drive/set_point_check.h"
#include "drive/stop_sequence.h"
#include "lab/lent.h"
#include "sentences.h"
#include "session/transports/port_list.h"

#include <QEventLoop>
#include <QTimer>

#include <algorithm>

namespace cli {

using namespace std::chrono_literals;
using drive::LinkState;
using drive::StopWord;

namespace {

constexpr auto kConnectWithin = 15s; ///< the drive gives up earlier by itself
constexpr auto kEndWithin = 30s; ///< of any wish; the drive ends each by itself
constexpr int kMostTries = 4; ///< of what could not leave in time
constexpr auto kIdleWithin = 2s; ///< after a stop
constexpr auto kTellsWithin = 2s; ///< a board that answers: its state
/// The last STOP that is sent blind has left.
constexpr auto kStopsLeave =
    std::chrono::duration_cast<Conversation::Milliseconds>(drive::StopSequence::kBlindTime + 500ms);
constexpr auto kFarewell = 500ms;

/// The one thread of the program: while it runs, so does what the user can interrupt it with.
session::Parts attendedHere(std::shared_ptr<session::Guardian> guardian)
{
    session::Parts parts = session::realParts();
    parts.attendance = session::Attendance::OwnThread;
    parts.guardian = std::move(guardian);
    return parts;
}

/// Of what measures a motor: while one answer is waited for nothing else is read, and its bus voltage has to be.
constexpr auto kExperimentPatience = 100ms;

session::Endpoint endpointOf(const Arguments &arguments)
{
    session::Endpoint endpoint =
        session::endpointFor(arguments.port, arguments.baud, arguments.protocol);
    endpoint.reopen = false;
    endpoint.patience = std::chrono::milliseconds(arguments.patience_ms);
    if (arguments.command != nullptr && arguments.command->ownsMotor)
        endpoint.patience = std::min<Duration>(endpoint.patience, kExperimentPatience);
    return endpoint;
}

} // namespace

Conversation::Conversation(const Arguments &arguments, const Interrupt &interrupt,
    std::shared_ptr<session::Guardian> guardian)
    : m_arguments(arguments)
    , m_interrupt(interrupt)
    , m_session(
          session::tapped(session::noted(attendedHere(std::move(guardian)), m_lentNote), m_tap))
{
    QObject::connect(m_lentNote.get(), &session::LentNote::left, this, [](const QString &texts) {
        if (!texts.isEmpty())
            Output::error(
                QString::fromStdString(lab::cutOffText(texts.toStdString())) + QLatin1Char('.'));
    });
    using session::Session;
    QObject::connect(&m_session, &Session::batch, this, &Conversation::onBatch);
    QObject::connect(&m_session, &Session::portChanged, this, &Conversation::onPort);
    QObject::connect(&m_session, &Session::interrupted, this, &Conversation::onInterruption);
    QObject::connect(
        &m_session, &Session::experimentEnded, this, [this](const lab::Outcome &outcome) {
            m_experimentEnded = outcome;
            Q_EMIT changed();
        });
    QObject::connect(&m_interrupt, &Interrupt::raised, this, &Conversation::changed);
}

Conversation::~Conversation() { close(); }

template <class T>
Outcome<T> Conversation::waitFor(
    const std::optional<T> &told, Milliseconds limit, drive::LinkReason late)
{
    const auto waited = waitUntil([&told] { return told.has_value(); }, limit);
    if (!waited)
        return tl::make_unexpected(waited.error());
    if (*waited == Waited::TimeOver)
        return failure(kNoConnection, sentenceOf(late, m_arguments));
    return *told;
}

Outcome<drive::Identified> Conversation::connect()
{
    m_session.open(endpointOf(m_arguments));
    return waitFor(m_board, kConnectWithin, drive::LinkReason::NoAnswer);
}

void Conversation::close()
{
    if (m_session.closed())
        return;
    m_stopping = true;
    m_session.close();
    (void)waitUntil([this] { return m_session.closed(); }, kFarewell);
}

Outcome<drive::Ended> Conversation::ask(const decltype(drive::Wish::what) &what)
{
    // On a computer that stalls a wish may grow old before it leaves. Nothing of it has left then, and the user
    // waits.
    const auto tooLate = [](const drive::Ended &ended) {
        const auto wasLate = [](const drive::WriteResult &write) {
            return write.outcome == drive::Outcome::NotSent && write.reason == drive::kTooLate;
        };
        return ended.outcome == drive::Outcome::NotSent
            && (ended.writes.empty()
                    ? ended.reason == drive::kTooLate
                    : std::all_of(ended.writes.begin(), ended.writes.end(), wasLate));
    };
    for (int tries = 1;; ++tries) {
        m_ended.reset();
        m_session.submit({.id = ++m_lastWish, .what = what, .source = drive::Source::CommandLine});
        auto ended = waitFor(m_ended, kEndWithin, drive::LinkReason::Silence);
        if (!ended || tries == kMostTries || !tooLate(*ended))
            return ended;
    }
}

Conversation::Asked Conversation::askToTheEnd(const decltype(drive::Wish::what) &what)
{
    const auto ended = ask(what);
    if (ended)
        return {*ended, m_broken};
    close(); // ends the wish, and tells how far it came
    return {m_ended, ended.error()};
}

Outcome<int> Conversation::command(
    const decltype(drive::Wish::what) &wish, const QString &what, const QString &advice)
{
    const auto ended = ask(wish);
    if (!ended)
        return tl::make_unexpected(ended.error());
    if (ended->outcome == drive::Outcome::Ok)
        return kDone;
    const QString reason = plainText(ended->reason);
    switch (ended->outcome) {
    case drive::Outcome::Unknown:
        return failure(kNoConnection,
            QStringLiteral("%1: the board's answer was lost, so it may have happened; look with "
                           "rotorscope-cli info.")
                .arg(what));
    case drive::Outcome::NotSent:
        return failure(kRefused,
            QStringLiteral("%1 was not sent%2.")
                .arg(what, reason.isEmpty() ? reason : QStringLiteral(": ") + reason));
    default:
        break;
    }
    const QString better = ended->reason == drive::kNoCurrentScale
        ? QStringLiteral("give it with --full-scale-current A")
        : ended->reason.ends_with(drive::kExpertMode)
        ? QStringLiteral("--max-rpm and --max-amps bound it then, --expert allows it")
        : advice;
    return failure(kRefused,
        QStringLiteral("%1 was refused%2; %3.")
            .arg(what, reason.isEmpty() ? reason : QStringLiteral(" (%1)").arg(reason), better));
}

Outcome<std::vector<drive::Reading>> Conversation::read(const std::vector<drive::RegisterId> &ids)
{
    m_readings.clear();
    const auto ended = ask(drive::Read{ids});
    if (!ended)
        return tl::make_unexpected(ended.error());
    std::vector<drive::Reading> readings;
    for (const drive::RegisterId id : ids) {
        const auto found = m_readings.find(id);
        readings.push_back(found != m_readings.end()
                ? found->second
                : drive::Reading{
                    .id = id, .status = drive::ReadStatus::NotSupported, .value = {}, .at = {}});
    }
    return readings;
}

Outcome<drive::MotorStatus> Conversation::status(int motor)
{
    const auto waited = waitUntil([&] { return m_status.contains(motor); },
        kTellsWithin + Milliseconds(m_arguments.patience_ms));
    if (!waited)
        return tl::make_unexpected(waited.error());
    if (*waited == Waited::TimeOver)
        return failure(
            kRefused, QStringLiteral("The board does not tell the state of motor %1.").arg(motor));
    return m_status.at(motor);
}

Outcome<drive::MotorStatus> Conversation::nextStatus(int motor)
{
    m_status.erase(motor);
    return status(motor);
}

Outcome<int> Conversation::bound(const drive::Identified &board)
{
    if (m_arguments.limits != drive::UserLimits{})
        if (auto set = command(m_arguments.limits, QStringLiteral("The limit")); !set)
            return set;
    for (int motor = 1; m_arguments.expert && motor <= board.identity.motors; ++motor) {
        if (drive::gapsIn(board.limits.at(static_cast<std::size_t>(motor - 1))).empty())
            continue;
        if (auto set = command(drive::ExpertMode{motor}, QStringLiteral("Expert mode")); !set)
            return set;
    }
    return kDone;
}

Outcome<drive::Identified> Conversation::scaled(const drive::Identified &board)
{
    const double amps = m_arguments.fullScaleCurrent_a;
    for (int motor = 1; amps > 0.0 && motor <= board.identity.motors; ++motor) {
        const auto taken = command(drive::CurrentScale{motor, amps},
            QStringLiteral("The full-scale current"), QStringLiteral("leave it out"));
        if (!taken)
            return tl::make_unexpected(taken.error());
    }
    return *m_board; // told anew with the units that follow from it
}

void Conversation::arm() { m_session.setArmed(true); }

Outcome<int> Conversation::armToMove()
{
    arm();
    if (!m_arguments.cyclicSetPoints)
        return kDone;
    return command(
        drive::CyclicSetPoints{}, QStringLiteral("Sending set-points with every exchange"));
}

Outcome<lab::Outcome> Conversation::run(const lab::Experiment &experiment)
{
    m_experimentEnded.reset();
    m_session.run(experiment);
    return waitFor(
        m_experimentEnded, lab::lengthOf(experiment) + kEndWithin, drive::LinkReason::Silence);
}

bool Conversation::allStopped(StopWord least) const
{
    for (int motor = 1; motor <= m_board->identity.motors; ++motor) {
        const auto word = m_stopWords.find(motor);
        if (word == m_stopWords.end() || word->second == StopWord::NotConfirmed
            || word->second < least)
            return false;
    }
    return true;
}

bool Conversation::stopsHaveLeft() const
{
    return std::any_of(m_motionLog.begin(), m_motionLog.end(), [](const auto &logged) {
        return logged.entry.act == drive::MotionAct::Stop && logged.entry.requests > 0;
    });
}

Outcome<StopWord> Conversation::stop(Milliseconds standstill)
{
    m_stopping = true;
    m_stopWords.clear();
    m_status.clear();
    m_session.stop();
    const auto idle = waitUntil([this] { return allStopped(StopWord::DriveIdle); }, kIdleWithin);
    if (!idle)
        return tl::make_unexpected(idle.error());
    if (*idle == Waited::TimeOver)
        return failure(m_status.empty() ? kNoConnection : kRefused, kStopNotConfirmed);
    return standstillWithin(standstill);
}

StopWord Conversation::standstillWithin(Milliseconds limit)
{
    const auto still = waitUntil([this] { return allStopped(StopWord::Standstill); }, limit);
    if (!still || *still != Waited::Happened)
        return StopWord::DriveIdle;
    const bool coasts = std::any_of(m_stopWords.begin(), m_stopWords.end(),
        [](const auto &word) { return word.second == StopWord::MayCoast; });
    return coasts ? StopWord::MayCoast : StopWord::Standstill;
}

Outcome<StopWord> Conversation::stopAtOnce(Milliseconds standstill)
{
    m_stopping = true;
    m_session.open(endpointOf(m_arguments));
    m_session.stop();
    const auto idle = [this] { return m_board && allStopped(StopWord::DriveIdle); };
    const auto givenUp = [&] { return idle() || m_broken || m_interrupt.number() != 0; };
    // A line that is told to be lost meanwhile is no reason to end: the STOPs go on leaving.
    auto waited = waitUntil(idle, kStopsLeave);
    if (waited && !idle() && !m_answered)
        waited = waitUntil(givenUp, kConnectWithin);
    if (waited && !idle() && m_answered)
        waited = waitUntil(givenUp, kIdleWithin);
    if (idle())
        return standstillWithin(standstill);
    Failure why{kRefused, QStringLiteral("Stop NOT confirmed.")};
    if (m_broken)
        why = *m_broken;
    else if (!m_answered)
        why = {kNoConnection, sentenceOf(drive::LinkReason::NoAnswer, m_arguments)};
    if (!m_answered)
        why.sentence += stopsHaveLeft() ? QStringLiteral(" STOPs were sent all the same.")
                                        : QStringLiteral(" No STOP could be sent.");
    why.sentence += QStringLiteral(" The motors may be turning: use the hardware stop.");
    return tl::make_unexpected(why);
}

Outcome<Waited> Conversation::waitUntil(const std::function<bool()> &condition, Milliseconds limit)
{
    QEventLoop loop;
    const auto over = [&] { return ended() || condition(); };
    if (!over()) {
        QObject::connect(this, &Conversation::changed, &loop, [&] {
            if (over())
                loop.quit();
        });
        QTimer::singleShot(limit, Qt::PreciseTimer, &loop, &QEventLoop::quit);
        loop.exec();
    }
    if (condition())
        return Waited::Happened;
    if (ended())
        return tl::make_unexpected(endReason());
    return Waited::TimeOver;
}

bool Conversation::ended() const
{
    if (m_stopping)
        return m_session.closed();
    return m_broken || m_interrupt.number() != 0;
}

Failure Conversation::endReason() const
{
    if (m_broken)
        return *m_broken;
    return {kInterrupted + m_interrupt.number(), QStringLiteral("Interrupted.")};
}

void Conversation::onBatch(const session::BatchPtr &batch)
{
    for (const drive::Event &event : batch->events)
        accept(event);
    m_session.acknowledge();
    Q_EMIT changed();
}

void Conversation::accept(const drive::Event &event)
{
    if (m_listener)
        m_listener(event);
    if (const auto *link = std::get_if<drive::LinkChanged>(&event)) {
        if (link->state == LinkState::Connected)
            m_answered = true;
        const bool wasReset = link->state == LinkState::Connected
            && link->reason == drive::LinkReason::BoardReset && m_board;
        if (m_stopping && link->state == LinkState::Connected)
            m_broken.reset(); // a stop goes on wherever it finds a board
        else if (link->state == LinkState::Lost || wasReset)
            m_broken = Failure{kNoConnection, sentenceOf(link->reason, m_arguments)};
    } else if (const auto *identified = std::get_if<drive::Identified>(&event)) {
        m_board = *identified;
    } else if (const auto *read = std::get_if<drive::RegistersRead>(&event)) {
        for (const drive::Reading &reading : read->readings)
            m_readings[reading.id] = reading;
    } else if (const auto *end = std::get_if<drive::Ended>(&event)) {
        if (end->id == m_lastWish)
            m_ended = *end;
    } else if (const auto *status = std::get_if<drive::MotorStatus>(&event)) {
        m_status[status->motor] = *status;
    } else if (const auto *motion = std::get_if<drive::MotionEntry>(&event)) {
        m_motionLog.push_back(session::loggedNow(*motion, QDateTime::currentDateTime()));
    } else if (const auto *counters = std::get_if<drive::LinkCounters>(&event)) {
        m_counters = *counters;
    } else if (const auto *progress = std::get_if<drive::StopProgress>(&event)) {
        m_stopWords[progress->motor] = progress->word;
    }
}

/// Stopped (Ctrl-Z) or asleep, and the motor could not be stopped: what was under way is not gone on with.
void Conversation::onInterruption(const session::Interruption &what)
{
    if (what.disarmed || what.stopped)
        m_broken = Failure{kRefused,
            QStringLiteral("This program or the computer stood still for %1 s: disarmed%2.")
                .arg(QString::number(toSeconds(what.length), 'f', 1),
                    what.stopped ? QStringLiteral(", and all motors were told to stop")
                                 : QString())};
    Q_EMIT changed();
}

void Conversation::onPort(session::PortState state, const session::PortError &why)
{
    const bool closed = state == session::PortState::Closed;
    if (closed && why.problem != session::PortProblem::None)
        m_broken = Failure{kNoConnection, sentenceOf(why, m_arguments)};
    Q_EMIT changed();
}

} // namespace cli
