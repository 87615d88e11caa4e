#include "widgets/window/workbench.h"

#include "widgets/files/open_recording.h"
#include "widgets/lab/text.h"

#include <QCoreApplication>
#include <QInputEvent>

namespace widgets {
namespace {

constexpr int kHeartbeatMs = 200;
/// What tells the session that this thread lives. Four late ones in a row are forgiven, a fifth disarms.
constexpr int kPulseMs = 100;

} // namespace

Workbench::Workbench(session::MakeSink makeSink, session::Parts parts, QObject *parent)
    : QObject(parent)
    , m_parts(std::move(parts))
    , m_archive(std::make_shared<session::DiskArchive>(
          session::DiskArchive::Config{.folder = session::archiveFolder()}))
    , m_capture({.archive = m_archive})
    , m_watchList(m_device, m_registers)
    , m_tap(std::make_shared<session::RecordingTap>())
    , m_recording(m_tap, {}, std::move(makeSink))
    , m_experimentTap(std::make_shared<session::RecordingTap>())
    , m_experiments(m_device, m_experimentTap, m_parts.clock)
    , m_thread(session::tapped(
          session::tapped(
              session::listened(
                  session::noted(session::replaying(m_parts, m_replay), m_lentNote), m_setPoints),
              m_tap),
          m_experimentTap))
{
    m_clock.start();
    connectSession();
    connectModels();
    connectTrigger();
    connectReplay();
    connectExperiments();
    m_edits.keepBeforeWriting(m_snapshots);
    connect(&m_heart, &QTimer::timeout, this, [this] {
        m_registers.refresh(now());
        m_faults.advance(m_recorder.samplesNow()); // also where nothing comes any more
        Q_EMIT heartbeat(now());
    });
    m_heart.start(kHeartbeatMs);
    m_pulse.setTimerType(Qt::PreciseTimer);
    connect(&m_pulse, &QTimer::timeout, this, &Workbench::pulse);
    m_pulse.start(kPulseMs);
    pulse();
    m_device.setActClock([this] { return m_inputAge.madeAt(m_parts.clock()); });
    QCoreApplication::instance()->installEventFilter(this);
}

Workbench::~Workbench() = default;

/// Notes how old each input is before anything is done with it.
bool Workbench::eventFilter(QObject *watched, QEvent *event)
{
    if (event->spontaneous() && event->isInputEvent())
        m_inputAge.note(static_cast<QInputEvent *>(event)->timestamp(), m_parts.clock());
    return QObject::eventFilter(watched, event);
}

void Workbench::pulse()
{
    m_inputAge.beat(m_parts.clock());
    m_thread.session()->attendFromAnyThread();
}

void Workbench::atSession(const std::function<void(session::Session &)> &what)
{
    session::Session *session = m_thread.session();
    QMetaObject::invokeMethod(
        session, [session, what] { what(*session); }, Qt::QueuedConnection);
}

void Workbench::connectSession()
{
    using session::Session;
    Session *session = m_thread.session();
    connect(&m_device, &Device::openWished, session, &Session::open);
    connect(&m_device, &Device::closeWished, session, &Session::close);
    connect(&m_device, &Device::wishMade, session, &Session::submit);
    connect(&m_device, &Device::armWished, session, &Session::setArmed);
    // A stop does not queue behind what was asked before it.
    connect(&m_device, &Device::stopWished, this, [this, session] {
        session->stopFromAnyThread();
        if (!m_device.portOpen()) // nor is it lost before a port that is still to be opened
            QMetaObject::invokeMethod(session, &Session::stop, Qt::QueuedConnection);
    });
    connect(&m_device, &Device::forgetStopWished, session, &Session::forgetStop);
    connect(session, &Session::stopsWanted, &m_device, &Device::stopsWanted);
    // A frozen window must not seem to hold anything: no queued calls.
    connect(&m_device, &Device::held, this,
        [session](int motor) { session->holdFromAnyThread(motor); });
    connect(&m_device, &Device::released, this, [session] { session->releaseFromAnyThread(); });

    connect(session, &Session::portChanged, &m_device, &Device::portChanged);
    connect(session, &Session::armedChanged, &m_device, &Device::armedChanged);
    connect(session, &Session::batch, &m_device, &Device::apply);
    connect(session, &Session::interrupted, &m_device, &Device::interrupted);
    connect(&m_device, &Device::batchApplied, session, &Session::acknowledge);
    connect(&m_device, &Device::samplesArrived, this, [this](const capture::SampleBlock &block) {
        m_replay->accept(capture::samplesOf(block));
        m_capture.append(block);
        Q_EMIT samplesStored(block);
    });
    connect(&m_device, &Device::streamStarted, &m_signalPlan, &SignalPlan::begin);
    connect(this, &Workbench::heartbeat, &m_signalPlan, &SignalPlan::refresh);
    connect(this, &Workbench::samplesStored, &m_recorder, &EventRecorder::stored);
    connect(&m_signalPlan, &SignalPlan::begunAnew, &m_events, &EventLog::clear);
    connect(&m_signalPlan, &SignalPlan::boardReplaced, &m_recorder, &EventRecorder::replaced);
    connect(&m_device, &Device::batchApplied, this, &Workbench::advance);
    connect(&m_signalPlan, &SignalPlan::renewed, this, &Workbench::advance);
    m_math.setPolled([this] { return m_signalPlan.planned().polled; });
    m_watchList.addDrawnSource([this] { return m_signalPlan.planned().polled; });
    connect(&m_signalPlan, &SignalPlan::changed, &m_watchList, &WatchList::changed);
}

void Workbench::advance()
{
    m_math.advance();
    m_trigger.advance();
    m_faults.advance(m_recorder.samplesNow());
    Q_EMIT advanced();
}

void Workbench::connectModels()
{
    const auto showBoard = [this] {
        m_registers.setMotorLimits(m_device.identified() ? m_device.identified()->limits
                                                         : std::vector<drive::MotorLimits>());
        m_registers.setCatalog(m_device.catalog(), m_device.motor());
        m_watchList.forget();
    };
    connect(&m_device, &Device::identityChanged, this, [this, showBoard] {
        showBoard();
        m_signalPlan.boardChanged();
    });
    connect(&m_device, &Device::motorChanged, this, showBoard);
    connect(&m_device, &Device::readingsArrived, this,
        [this](const std::vector<drive::Reading> &readings) {
            m_replay->accept(readings.size());
            m_registers.accept(readings, now());
            m_signalPlan.accept(readings);
        });
    connect(&m_device, &Device::motionLogged, this, [this](const drive::MotionEntry &entry) {
        m_motionLog.accept(entry, QDateTime::currentDateTime());
    });
    connect(&m_device, &Device::linkStateChanged, this,
        [this] { m_registers.setBelieved(m_device.answering()); });
}

void Workbench::connectTrigger()
{
    const auto tell = [this] {
        const bool replay = replaying(m_device) && m_device.portOpen();
        m_trigger.setAwaitsSamples(!m_signalPlan.showsFile() || replay);
    };
    connect(&m_signalPlan, &SignalPlan::changed, this, tell);
    connect(&m_device, &Device::portStateChanged, this, tell);
    connect(&m_recorder, &EventRecorder::faulted, &m_faults, &FaultRecords::faulted);
    connect(&m_signalPlan, &SignalPlan::forgetting, &m_faults, &FaultRecords::finish);
    connect(&m_signalPlan, &SignalPlan::forgot, &m_trigger, &Trigger::forget);
    using Kind = scope::EventTrigger::Kind;
    connect(&m_recorder, &EventRecorder::stateChanged, this,
        [this](double seconds, EventKind kind, quint32 which) {
            m_trigger.event(
                kind == EventKind::Fault ? Kind::Fault : Kind::StateChange, seconds, which);
        });
    connect(&m_recorder, &EventRecorder::written, this,
        [this](double seconds, const QString &name) { m_trigger.written(seconds, {name}); });
    // When its bytes left, on the axis of the samples; a polled reference comes much later.
    connect(
        m_setPoints.get(), &session::SetPointTap::left, this,
        [this](const drive::SentSetPoint &sent) {
            m_trigger.event(Kind::SetPoint, sent.seconds, static_cast<quint32>(sent.motor));
            m_recorder.left(sent.wish, sent.within_s);
        },
        Qt::QueuedConnection);
    connect(
        m_setPoints.get(), &session::SetPointTap::ended, this,
        [this](const drive::SetPointsEnd &end) {
            if (end.held)
                m_recorder.left(end.wish, end.within_s);
        },
        Qt::QueuedConnection);
}

void Workbench::connectReplay()
{
    connect(m_replay.get(), &session::Replay::happened, this,
        [this, writes = ReplayedWrites()](const session::ReplayedEntry &entry) mutable {
            addReplayed(m_events, entry);
            if (const auto write = writes.accept(entry))
                m_trigger.written(write->seconds, write->names);
            if (std::holds_alternative<recorded::Note>(entry.entry))
                Q_EMIT noteReplayed(entry.seconds);
        });
}

void Workbench::connectExperiments()
{
    session::Session *session = m_thread.session();
    connect(&m_experiments, &Experiments::wished, session, &session::Session::run);
    connect(session, &session::Session::experimentEnded, &m_experiments, &Experiments::end);
    connect(session, &session::Session::experimentEnded, session,
        [note = m_lentNote] { note->tell(); }); // in the session's thread, where the note is
    // A file that is being written holds them as one of the command line does.
    connect(&m_experiments, &Experiments::noted, this,
        [this](qint64 at, const recorded::Happening &what) { m_recording.add(at, what); });
    connect(
        &m_experiments, &Experiments::began, &m_motion, [this] { m_motion.setExperiment(true); });
    connect(&m_experiments, &Experiments::ended, this, [this](const Experiments::RunPtr &run) {
        m_motion.setExperiment(false);
        m_recorder.noteExperiment(run->outcome.at, endText(run->outcome));
    });
}

} // namespace widgets
