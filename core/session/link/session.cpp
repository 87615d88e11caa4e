#include "session/link/session.h"

#include "drive/stop_sequence.h"
#include "lab/runner.h"
#include "session/recording/session_tap.h"

#include <QCoreApplication>
#include <QEvent>
#include <QLoggingCategory>

#include <algorithm>

Q_LOGGING_CATEGORY(lcLink, "link", QtWarningMsg)
Q_LOGGING_CATEGORY(lcLinkBytes, "link.bytes", QtWarningMsg)

namespace session {

namespace {

constexpr Duration kReopenEvery = std::chrono::milliseconds(500);
/// How long a drive may take to end its streaming before the port is closed under it.
constexpr Duration kFarewell = std::chrono::milliseconds(300);
/// A stop that is open when the port is to be closed; as long as STOPs are sent without a link.
constexpr Duration kLastStop = std::chrono::seconds(2);
constexpr Duration kLeastBetweenWakes = std::chrono::microseconds(900);
constexpr Duration kLongestWait = std::chrono::seconds(60);
constexpr int kMostRounds = 16; ///< of output and its consequences in one turn

/// What takes the motor out of an experiment's hands; parameters that it has not borrowed may be written meanwhile.
bool commands(const drive::Wish &wish, const catalog::Catalog &catalog)
{
    if (const auto *write = std::get_if<drive::Write>(&wish.what))
        return std::ranges::any_of(write->writes, [&](const drive::RegisterWrite &one) {
            const catalog::RegisterInfo *info = catalog.find(one.id);
            return info == nullptr || info->effect != catalog::Effect::Kept;
        });
    return !std::holds_alternative<drive::Read>(wish.what)
        && !std::holds_alternative<drive::Stream>(wish.what)
        && !std::holds_alternative<drive::Watch>(wish.what)
        && !std::holds_alternative<drive::UserLimits>(wish.what);
}

constexpr const char *kLentOut = "a register of it is lent to an experiment until that ends";

/// Whether it writes what the experiment brings back at its end, which would overwrite what was written meanwhile.
bool writesLent(const drive::Wish &wish, const lab::Experiment &experiment)
{
    const auto *write = std::get_if<drive::Write>(&wish.what);
    return write != nullptr
        && std::ranges::any_of(
            lab::conditionsOf(experiment).lent, [&](const drive::RegisterWrite &lent) {
                return std::ranges::find(write->writes, lent.id, &drive::RegisterWrite::id)
                    != write->writes.end();
            });
}

const auto kStopEvent = static_cast<QEvent::Type>(QEvent::registerEventType());

ByteView viewOf(const QByteArray &bytes)
{
    return {reinterpret_cast<const std::uint8_t *>(bytes.constData()),
        static_cast<std::size_t>(bytes.size())};
}

} // namespace

Session::Session(Parts parts, QObject *parent)
    : QObject(parent)
    , m_parts(std::move(parts))
    , m_elapsed(m_parts.elapsed ? m_parts.elapsed : m_parts.clock)
    , m_deadMan(m_parts.attendance)
    , m_timer(this)
{
    qRegisterMetaType<BatchPtr>("session::BatchPtr");
    qRegisterMetaType<PortState>("session::PortState");
    qRegisterMetaType<PortError>("session::PortError");
    qRegisterMetaType<Endpoint>("session::Endpoint");
    qRegisterMetaType<drive::Wish>("drive::Wish");
    qRegisterMetaType<Interruption>("session::Interruption");
    qRegisterMetaType<lab::Experiment>("lab::Experiment");
    qRegisterMetaType<lab::Outcome>("lab::Outcome");
    connect(&m_timer, &WakeTimer::due, this, [this] {
        m_wokenAt = m_parts.clock();
        step(m_wokenAt);
    });
}

Session::~Session()
{
    if (m_transport)
        m_transport->disconnect(this);
}

void Session::stopFromAnyThread()
{
    m_stopRequested.store(true);
    QCoreApplication::postEvent(this, new QEvent(kStopEvent), Qt::HighEventPriority);
}

bool Session::event(QEvent *event)
{
    if (event->type() != kStopEvent)
        return QObject::event(event);
    step(wake());
    return true;
}

/// The time, at whose call everything begins that is not the timer's: a gap, or a dead interface, is seen before what
/// was asked for is done.
TimePoint Session::wake()
{
    const TimePoint now = m_parts.clock();
    lookUp(now);
    return now;
}

void Session::lookUp(TimePoint now)
{
    const TimePoint elapsed = m_elapsed();
    const Duration gap = m_gap.notice(now, elapsed, std::exchange(m_wakeDue, std::nullopt));
    if (m_phase != Phase::Open)
        return;
    const bool armed = m_drive->armed();
    if (gap > Duration::zero()) {
        qCInfo(lcLink) << "nothing ran for" << toSeconds(gap) << "s";
        // What was to leave before is too late, also a command behind its header.
        if (!m_drive->stopOpen())
            m_outbox.add({Output{.bytes = {}, .gapBefore = {}, .dropsEarlier = true}});
        m_drive->doubt(now);
    }
    const DeadMan::Verdict verdict = m_deadMan.judge(m_stamps.take(), armed, gap, elapsed);
    if (verdict.disarm)
        m_drive->disarm();
    if (verdict.stopMotor != 0)
        submitToDrive(
            {.id = 0, .what = drive::Command{drive::MotorAction::StopMotor, verdict.stopMotor}},
            now);
    if (verdict.stopAll)
        stopNow(now);
}

void Session::open(const Endpoint &endpoint)
{
    if (linked()) {
        m_next = endpoint;
        if (m_phase == Phase::Open)
            startClosing();
        return;
    }
    const TimePoint now = wake();
    openNow(endpoint, now);
    step(now);
}

void Session::openNow(const Endpoint &endpoint, TimePoint now)
{
    m_endpoint = endpoint;
    m_stream.reset();
    m_watch.reset();
    m_takeUpAgain = false;
    m_driven.leave();
    m_deadMan.begin(m_elapsed());
    const PortError error = tryOpen(now);
    if (error.problem == PortProblem::None) {
        Q_EMIT portChanged(PortState::Open, {});
        return;
    }
    m_phase = Phase::Closed;
    Q_EMIT portChanged(PortState::Closed, error);
}

/// A fresh transport and a fresh, read-only drive.
PortError Session::tryOpen(TimePoint now)
{
    auto transport = m_parts.transport(m_endpoint);
    if (!transport)
        return {PortProblem::Other, {}};
    if (PortError error = transport->open(now); error.problem != PortProblem::None) {
        qCInfo(lcLink) << "cannot open" << m_endpoint.path << error.detail;
        return error;
    }
    qCInfo(lcLink) << "opened" << m_endpoint.path << "at" << m_endpoint.baud;
    connect(transport.get(), &Transport::received, this, &Session::onReceived);
    connect(transport.get(), &Transport::failed, this, &Session::onFailed);
    connect(transport.get(), &Transport::readyChanged, this, &Session::onReady);
    m_transport = std::move(transport);
    const drive::LineMemory &memory = m_memory[m_endpoint.path];
    m_endpoint.spoken = memory.spoken;
    if (m_parts.guardian)
        m_parts.guardian->watch(m_transport->descriptor());
    m_drive = m_parts.drive(m_endpoint);
    m_drive->remember(memory);
    m_outbox = Outbox(m_endpoint.baud);
    m_failure.reset();
    m_phase = Phase::Open;
    if (m_limits)
        submitToDrive({.id = 0, .what = *m_limits}, now); // before anything else can be asked
    m_drive->connect(now);
    if (m_stops.any())
        stopDrive(now);
    return {};
}

void Session::close()
{
    m_next.reset();
    if (m_phase == Phase::Reopening) {
        m_phase = Phase::Closed;
        Q_EMIT portChanged(PortState::Closed, {});
    } else if (m_phase == Phase::Open) {
        startClosing();
    }
}

void Session::startClosing()
{
    const TimePoint now = wake();
    interruptExperiment("the port was closed", now);
    if (m_drive->stopOpen() && now < m_stopUntil) {
        m_phase = Phase::LastStop;
        m_deadline = m_stopUntil;
        return step(now);
    }
    m_phase = Phase::Closing;
    m_deadline = now + kFarewell;
    m_saidFarewell = false;
    m_driven.leave(); // the caller has decided about the motors
    m_drive->disconnect(now);
    step(now);
}

void Session::submit(const drive::Wish &wish)
{
    if (const auto *stream = std::get_if<drive::Stream>(&wish.what))
        m_stream = *stream;
    else if (const auto *watch = std::get_if<drive::Watch>(&wish.what))
        m_watch = *watch;
    else if (const auto *limits = std::get_if<drive::UserLimits>(&wish.what))
        m_limits = *limits;
    const TimePoint now = wake();
    const bool kept = std::holds_alternative<drive::UserLimits>(wish.what);
    if (m_experiment && writesLent(wish, m_experiment->experiment())) {
        m_batcher.add(drive::Ended{.id = wish.id,
            .outcome = drive::Outcome::Refused,
            .reason = kLentOut,
            .writes = {},
            .byProgram = true});
        return step(now);
    }
    if (m_experiment && commands(wish, *m_experiment->experiment().subject.catalog))
        interruptExperiment("another command went to the motor", now);
    const bool isSignals = std::holds_alternative<drive::Stream>(wish.what)
        || std::holds_alternative<drive::Watch>(wish.what);
    if (m_experiment && isSignals) { // it needs its own until it ends; then these are taken up
        if (wish.id != 0)
            m_batcher.add(drive::Ended{
                .id = wish.id, .outcome = drive::Outcome::Ok, .reason = {}, .writes = {}});
    } else if (m_phase == Phase::Open) {
        m_driven.submitted(wish, m_drive->armed(), now);
        submitToDrive(wish, now);
    } else if (wish.id != 0) {
        m_batcher.add(drive::Ended{.id = wish.id,
            .outcome = kept ? drive::Outcome::Ok : drive::Outcome::NotSent,
            .reason = {},
            .writes = {}});
    }
    step(now);
}

void Session::stop()
{
    m_stopRequested = true;
    step(wake());
}

void Session::forgetStop()
{
    m_stops.forget();
    tellStops();
}

void Session::setArmed(bool armed, std::optional<TimePoint> madeAt)
{
    const TimePoint now = wake();
    if (m_phase == Phase::Open) {
        if (armed)
            arm(madeAt.value_or(now), now);
        else
            disarm(now);
    }
    step(now);
}

void Session::arm(TimePoint madeAt, TimePoint now)
{
    const Duration age = now - madeAt;
    if (age > drive::kWishExpiresAfter || m_deadMan.absent())
        return m_deadMan.tell({Interruption::Cause::LateArming, age, false, false});
    m_drive->arm();
    if (m_drive->armed())
        m_deadMan.armed();
}

void Session::disarm(TimePoint now)
{
    if (m_experiment) {
        m_experiment->disarm();
        (void)stopForExperiment(now);
    }
    // The user's own choice. Where the drive is not armed any more, this follows from something else.
    if (m_drive->armed())
        m_deadMan.disarmed();
    m_drive->disarm();
}

void Session::stopOwn()
{
    const TimePoint now = wake();
    if (m_deadMan.responsible())
        m_stopRequested = true;
    step(now);
}

void Session::acknowledge()
{
    m_batcher.acknowledge();
    step(wake());
}

void Session::onReceived(const QByteArray &bytes)
{
    if (!m_drive)
        return;
    qCDebug(lcLinkBytes).noquote() << "<" << bytes.toHex(' ');
    const TimePoint now = m_heardAt = m_parts.clock();
    for (const auto &tap : m_parts.taps)
        tap->onLink(recorded::LinkBytes::Direction::Received, viewOf(bytes), now);
    lookUp(now);
    if (m_stopRequested.exchange(false)) // before what the drive would ask next
        stopNow(now);
    m_drive->receive(viewOf(bytes), now);
    if (!m_stepping)
        step(now);
}

void Session::onReady(bool high)
{
    if (!m_drive)
        return;
    const TimePoint now = m_heardAt = wake();
    m_drive->handleReady(high, now);
    if (!m_stepping)
        step(now);
}

void Session::onFailed(const PortError &error)
{
    m_failure = error;
    if (!m_stepping)
        step(wake());
}

void Session::step(TimePoint now)
{
    if (m_stepping)
        return; // called back from within: the outer turn goes on
    if (linked() && handsOff())
        return yieldPort(now);
    m_stepping = true;
    lookUp(now);
    if (m_phase == Phase::Reopening && now >= m_deadline)
        reopen(now);
    if (m_stopRequested.exchange(false))
        stopNow(now);
    if (linked())
        runLink(now);
    m_stepping = false;
    tellGuardian(now);

    settleStop();
    if (linked() && m_failure)
        afterFailure(now);
    else if (m_phase == Phase::LastStop && (!m_drive->stopOpen() || now >= m_deadline))
        return startClosing();
    else if (m_phase == Phase::Closing
        && ((m_saidFarewell && m_outbox.idle()) || now >= m_deadline))
        finishClosing();
    gather(now);
    tellArmed();
    tellStops();
    tell(now);
    for (const Interruption &news : m_deadMan.takeNews())
        Q_EMIT interrupted(news);
    armTimer(m_parts.clock());
}

/// Where nothing moves, samples may be some milliseconds late.
void Session::gather(TimePoint now)
{
    const bool still = m_phase == Phase::Open && !m_driven.any() && !m_experiment;
    m_gathers = still ? m_drive->gathersFor() : Duration::zero();
    if (linked())
        m_transport->gather(m_gathers, now);
    m_batcher.setCalm(m_gathers > Duration::zero());
}

void Session::reopen(TimePoint now)
{
    m_deadline = now + kReopenEvery;
    if (tryOpen(now).problem != PortProblem::None)
        return;
    m_takeUpAgain = true;
    Q_EMIT portChanged(PortState::Open, {});
}

void Session::runLink(TimePoint now)
{
    if (!m_failure)
        m_transport->advance(now);
    if (m_failure)
        return;
    // The port may have taken long, and what it brought was heard at its own time: what is asked for next is of now.
    now = m_parts.clock();
    m_drive->handleTimeout(now);
    tellGuardian(now);
    exchange(now);
    for (int round = 0; round < kMostRounds && runExperiment(now); ++round) {
        tellGuardian(now);
        exchange(now);
    }
}

void Session::run(const lab::Experiment &experiment)
{
    const TimePoint now = wake();
    const char *why = m_phase != Phase::Open ? "no port is open"
        : m_experiment                       ? "another experiment is running"
        : !m_drive->armed()                  ? "the drive is not armed"
                                             : nullptr;
    if (why != nullptr) {
        Q_EMIT experimentEnded({lab::End::Refused, why, now});
        return;
    }
    m_experiment = std::make_unique<lab::Runner>(experiment);
    m_experiment->begin(now, m_ranAt);
    step(now);
}

/// Lets the experiment go on; true if it asked for something. Its Stop comes before all else.
bool Session::runExperiment(TimePoint now)
{
    if (!m_experiment)
        return false;
    if (m_phase == Phase::Open && !m_drive->armed())
        m_experiment->interrupt("the drive is not armed any more");
    m_experiment->advance(now);
    const bool stops = stopForExperiment(now);
    std::vector<drive::Wish> wishes = m_experiment->takeWishes();
    for (const drive::Wish &wish : wishes) {
        m_driven.submitted(wish, m_drive->armed(), now);
        submitToDrive(wish, now);
    }
    if (!m_experiment->over())
        return stops || !wishes.empty();
    endExperiment(now);
    return true;
}

void Session::interruptExperiment(const std::string &why, TimePoint now)
{
    if (!m_experiment)
        return;
    m_experiment->interrupt(why);
    (void)stopForExperiment(now);
}

/// If it asks for a Stop, which goes ahead of what has ended it: behind a Stop that is not sent any more.
bool Session::stopForExperiment(TimePoint now)
{
    if (!m_experiment->takeStop())
        return false;
    stopNow(now);
    m_deadMan.stopped();
    return true;
}

/// What was recorded and read before is again, whichever way it ended.
void Session::endExperiment(TimePoint now)
{
    lab::Outcome outcome = m_experiment->outcome();
    outcome.at = now;
    m_experiment.reset();
    if (m_phase == Phase::Open) {
        submitToDrive({.id = 0, .what = m_stream.value_or(drive::Stream{})}, now);
        submitToDrive({.id = 0, .what = m_watch.value_or(drive::Watch{})}, now);
    }
    Q_EMIT experimentEnded(outcome);
}

void Session::tellGuardian(TimePoint now)
{
    Guardian *guardian = m_parts.guardian.get();
    if (guardian == nullptr)
        return;
    if (m_driven.any() && m_drive)
        guardian->setScript(m_drive->stopScript(), m_endpoint.baud);
    guardian->setDriven(m_driven.any());
    m_stampedAt = now;
}

bool Session::handsOff() const
{
    return m_parts.guardian && m_parts.guardian->act() != Guardian::Act::None;
}

/// The guardian was faster, and sends perhaps until now: closing the port would spoil the line under it.
void Session::yieldPort(TimePoint now)
{
    m_stampedAt = now;
    if (!m_yieldBy)
        m_yieldBy = now + 2 * Guardian::kRepetitions * Guardian::kRepeat;
    if (m_parts.guardian->act() == Guardian::Act::Stopping && now < *m_yieldBy)
        return armTimer(now);
    qCWarning(lcLink) << "the guardian has stopped the motors: connecting anew";
    m_yieldBy.reset();
    m_failure = PortError{PortProblem::TakenOver, {}};
    afterFailure(now);
    armTimer(now);
}

void Session::submitToDrive(drive::Wish wish, TimePoint now)
{
    for (const auto &tap : m_parts.taps)
        tap->onWish(wish, now);
    m_drive->submit(std::move(wish), now);
}

void Session::stopDrive(TimePoint now)
{
    m_drive->stop(now); // before anything else
    for (const auto &tap : m_parts.taps)
        tap->onStop(now);
}

/// Output, what follows from its having left, and so on until nothing more can leave now.
void Session::exchange(TimePoint now)
{
    for (int round = 0; round < kMostRounds && !m_failure && !handsOff(); ++round) {
        if (m_stopRequested.exchange(false)) // since this turn began, which may have taken long
            stopNow(now);
        std::vector<Output> outputs = m_drive->takeOutput();
        for (const Output &output : outputs) {
            qCDebug(lcLinkBytes).noquote()
                << ">"
                << QByteArray::fromRawData(reinterpret_cast<const char *>(output.bytes.data()),
                       static_cast<qsizetype>(output.bytes.size()))
                       .toHex(' ');
        }
        m_outbox.add(std::move(outputs));
        m_outbox.pump(*m_transport, m_parts.clock, [this](ByteView bytes, TimePoint at) {
            for (const auto &tap : m_parts.taps)
                tap->onLink(recorded::LinkBytes::Direction::Sent, bytes, at);
        });
        if (!m_outbox.allSent(*m_transport, now))
            break;
        m_drive->handleSent(now);
    }
    collectEvents(now);
}

void Session::collectEvents(TimePoint now)
{
    std::vector<drive::Event> events = m_drive->takeEvents();
    const TimePoint at = std::max(now, m_heardAt); // never before the bytes that they follow from
    for (const auto &tap : m_parts.taps)
        for (const drive::Event &event : events)
            tap->onEvent(event, at);
    bool identified = false;
    for (drive::Event &event : events) {
        if (const auto *link = std::get_if<drive::LinkChanged>(&event)) {
            qCInfo(lcLink) << "link state" << static_cast<int>(link->state) << "reason"
                           << static_cast<int>(link->reason);
            m_saidFarewell = m_saidFarewell || link->state == drive::LinkState::Closed;
        }
        if (const auto *stream = std::get_if<drive::StreamStarted>(&event))
            qCInfo(lcLink) << "stream of" << stream->layout.fast.size() << "fast and"
                           << stream->layout.slow.size() << "slow signals";
        if (const auto *status = std::get_if<drive::MotorStatus>(&event)) {
            m_deadMan.acceptStatus(*status);
            if (!drive::isDriveIdle(*status))
                m_ranAt = now;
        }
        identified = identified || std::holds_alternative<drive::Identified>(event);
        m_driven.told(event, now);
        if (m_experiment)
            m_experiment->accept(event, now);
        m_batcher.add(std::move(event));
    }
    if (identified && m_takeUpAgain)
        takeUpAgain(now);
}

/// Streaming and watching go on after a reopening: neither moves a motor.
void Session::takeUpAgain(TimePoint now)
{
    m_takeUpAgain = false;
    if (m_stream)
        submitToDrive({.id = 0, .what = *m_stream}, now);
    if (m_watch)
        submitToDrive({.id = 0, .what = *m_watch}, now);
}

/// The port is gone: the drive ends all its wishes, then the port is told as closed, once.
void Session::afterFailure(TimePoint now)
{
    const PortError why = *m_failure;
    qCInfo(lcLink) << "port lost" << m_endpoint.path << why.detail;
    if (m_phase != Phase::Closing)
        m_drive->disconnect(now);
    (void)m_drive->takeOutput();
    collectEvents(now);
    if (m_experiment)
        m_experiment->lose("the port was lost");
    if (runExperiment(now))
        collectEvents(now);
    const bool again =
        m_phase == Phase::Open && m_endpoint.reopen && m_endpoint.kind == Endpoint::Kind::Serial;
    dropLink();
    m_phase = again ? Phase::Reopening : Phase::Closed;
    m_deadline = now + kReopenEvery;
    tellRest();
    tellArmed();
    Q_EMIT portChanged(PortState::Closed, why);
    openNext();
}

void Session::finishClosing()
{
    dropLink();
    m_phase = Phase::Closed;
    tellRest();
    tellArmed();
    Q_EMIT portChanged(PortState::Closed, {});
    openNext();
}

void Session::openNext()
{
    if (m_next && m_phase == Phase::Closed)
        openNow(*std::exchange(m_next, std::nullopt), m_parts.clock());
}

/// The transport may be the sender of the signal that led here: it goes when the event loop is
/// back.
void Session::dropLink()
{
    m_transport->disconnect(this);
    // What could not leave must not leave unattended; but a STOP may.
    if (!m_stops.at(m_endpoint))
        m_transport->discardOutput();
    if (m_parts.guardian)
        m_parts.guardian->letGo();
    m_transport->close();
    m_transport.release()->deleteLater();
    m_memory[m_endpoint.path] = m_drive->memory();
    m_drive.reset();
    m_outbox = Outbox(1);
    m_failure.reset();
}

void Session::stopNow(TimePoint now)
{
    if (m_phase == Phase::Closed)
        return; // no port is known that it could be for
    qCInfo(lcLink) << "stop";
    if (m_experiment)
        m_experiment->stopped();
    m_stops.want(m_endpoint);
    m_stopUntil = now + kLastStop;
    if (m_phase == Phase::Reopening) {
        m_deadline = now;
        return reopen(now);
    }
    if (m_phase != Phase::Open) {
        if (m_next)
            m_stops.want(*m_next);
        if (m_phase == Phase::Closing && m_saidFarewell)
            m_drive->connect(now);
        m_phase = Phase::LastStop;
        m_deadline = m_stopUntil;
    }
    stopDrive(now);
}

/// Evidence, and nothing else, ends the wish: the drive was told to stop in this connection.
void Session::settleStop()
{
    const bool stopping = m_phase == Phase::Open || m_phase == Phase::LastStop;
    if (stopping && !m_failure && m_stops.any() && !m_drive->stopOpen())
        m_stops.settle(m_endpoint);
}

void Session::tell(TimePoint now)
{
    if (const BatchPtr next = m_batcher.take(now))
        Q_EMIT batch(next);
}

void Session::tellRest()
{
    if (const BatchPtr rest = m_batcher.takeAll())
        Q_EMIT batch(rest);
}

void Session::tellArmed()
{
    const bool armed = m_drive && m_drive->armed();
    if (std::exchange(m_armed, armed) != armed)
        Q_EMIT armedChanged(armed);
}

void Session::tellStops()
{
    const QStringList ports = m_stops.portsBut(linked() ? &m_endpoint : nullptr);
    if (std::exchange(m_stopsTold, ports) != ports)
        Q_EMIT stopsWanted(ports);
}

std::optional<TimePoint> Session::nextStep() const
{
    std::optional<TimePoint> next;
    if (const auto due = m_batcher.due())
        earliest(next, *due + m_gathers);
    if (m_phase != Phase::Closed && m_phase != Phase::Open)
        earliest(next, m_deadline);
    if (m_yieldBy)
        return m_stampedAt + Guardian::kRepeat;
    if (linked()) {
        if (m_driven.any() && m_parts.guardian)
            earliest(next, m_stampedAt + Guardian::kStampEvery);
        earliest(next, m_drive->nextTimeout());
        earliest(next, m_outbox.nextDue(m_gathers));
        earliest(next, m_transport->nextWake());
        if (m_experiment)
            earliest(next, m_experiment->nextTimeout());
    }
    if (m_phase == Phase::Open)
        if (const auto wait = m_deadMan.nextLook(m_drive->armed(), m_elapsed()))
            earliest(next, m_parts.clock() + *wait);
    return next;
}

/// Exact, so that a drive that is asked every millisecond is asked in each; but not much oftener than that, because a
/// drive that is always due must not starve the port, nor a simulated motor the processor.
void Session::armTimer(TimePoint now)
{
    const std::optional<TimePoint> next = nextStep();
    if (!next) {
        m_timer.stop();
        return;
    }
    const Duration wait =
        std::min<Duration>(std::max(*next, m_wokenAt + kLeastBetweenWakes) - now, kLongestWait);
    m_wakeDue = now + std::max(wait, Duration::zero());
    m_timer.start(wait);
}

} // namespace session
