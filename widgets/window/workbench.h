// Workbench: the parts of Rotorscope that are not widgets, made and connected: the session in its thread, the device,
// the registers, the signals and the capture that they are recorded in, the events, the polling and one heartbeat. It
// decides nothing; panels are given its parts.
//
// Outlives every window that shows it, and needs none.
#pragma once

#include "capture/capture.h"
#include "session/archive/disk_archive.h"
#include "session/link/session_thread.h"
#include "session/recording/lent_note.h"
#include "session/recording/recording.h"
#include "session/recording/replay.h"
#include "session/recording/session_tap.h"
#include "widgets/base/device.h"
#include "widgets/control/input_age.h"
#include "widgets/control/motion_gate.h"
#include "widgets/control/motion_log_model.h"
#include "widgets/files/event_recorder.h"
#include "widgets/lab/experiments.h"
#include "widgets/measuring/math_channels.h"
#include "widgets/registers/edits.h"
#include "widgets/registers/model.h"
#include "widgets/registers/watch_list.h"
#include "widgets/scope/events/fault_records.h"
#include "widgets/scope/events/log.h"
#include "widgets/scope/signals/plan.h"
#include "widgets/scope/trigger/trigger.h"
#include "widgets/snapshots/auto.h"
#include "widgets/snapshots/recorder.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace widgets {

class Workbench : public QObject {
    Q_OBJECT
public:
    /// @param makeSink  where recordings go; tests bring disks that are full
    /// @param parts  what the session is made of, its guardian with it; tests bring lines that are judged
    explicit Workbench(session::MakeSink makeSink = session::makeDiskSink,
        session::Parts parts = session::realParts(), QObject *parent = nullptr);
    ~Workbench() override;

    Device &device() { return m_device; }
    RegisterModel &registers() { return m_registers; }
    RegisterEdits &edits() { return m_edits; }
    AutoSnapshots &snapshots() { return m_snapshots; }
    MotionGate &motion() { return m_motion; } ///< what moves a motor goes through here
    Experiments &experiments() { return m_experiments; } ///< what moves it by itself, here
    MotionLogModel &motionLog() { return m_motionLog; }
    capture::Capture &capture() { return m_capture; }
    SignalPlan &signalPlan() { return m_signalPlan; }
    MathChannels &math() { return m_math; }
    EventLog &events() { return m_events; }
    EventRecorder &eventRecorder() { return m_recorder; }
    const FaultRecords &faultRecords() const { return m_faults; }
    Trigger &trigger() { return m_trigger; }
    /// Where the capture puts what memory has no room for; for other captures as well.
    const std::shared_ptr<session::DiskArchive> &archive() { return m_archive; }
    session::Recording &recording() { return m_recording; }
    session::Replay &replay() { return *m_replay; }
    session::SetPointTap &setPoints() { return *m_setPoints; }
    session::LentNote &lentNote() { return *m_lentNote; }
    WatchList &watchList() { return m_watchList; }
    /// Since the workbench was made.
    Milliseconds now() const { return Milliseconds(m_clock.elapsed()); }
    TimePoint sessionTime() const { return m_sessionClock(); } ///< as it stamps what boards tell
    void setSessionClock(session::Clock clock) { m_sessionClock = std::move(clock); } ///< for tests

    /// Calls `what` in the session's thread, where a frozen window does not delay it.
    void atSession(const std::function<void(session::Session &)> &what);

Q_SIGNALS:
    void samplesStored(const capture::SampleBlock &block); ///< in the capture
    void advanced(); ///< there may be new samples; what is computed from them is there, too
    void noteReplayed(double seconds); ///< in the events
    void heartbeat(widgets::Milliseconds now); ///< some times a second: ages, rates

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void pulse();
    void advance();
    void connectTrigger();
    void connectSession();
    void connectModels();
    void connectReplay();
    void connectExperiments();

    session::Parts m_parts; ///< one clock for the session and for what it is asked
    InputAge m_inputAge;
    QElapsedTimer m_clock;
    session::Clock m_sessionClock = m_parts.clock; ///< what boards tell is stamped by it
    Device m_device;
    RegisterModel m_registers;
    AutoSnapshots m_snapshots{m_device, autoSnapshotFolder()};
    RegisterEdits m_edits{m_device, m_registers};
    MotionGate m_motion{m_device, m_registers};
    MotionLogModel m_motionLog;
    std::shared_ptr<session::DiskArchive> m_archive;
    capture::Capture m_capture;
    SignalPlan m_signalPlan{m_device, m_capture};
    MathChannels m_math{m_capture}; ///< before the trigger, which may watch one of them
    EventLog m_events;
    EventRecorder m_recorder{m_device, m_capture, m_events, [this] { return now(); }};
    FaultRecords m_faults{m_capture};
    Trigger m_trigger{m_capture, [this] { return m_recorder.samplesNow(); }};
    WatchList m_watchList;
    QTimer m_heart;
    QTimer m_pulse; ///< also while the models are busy with a heartbeat
    std::shared_ptr<session::Replay> m_replay = std::make_shared<session::Replay>();
    std::shared_ptr<session::SetPointTap> m_setPoints = std::make_shared<session::SetPointTap>();
    std::shared_ptr<session::LentNote> m_lentNote = std::make_shared<session::LentNote>();
    std::shared_ptr<session::RecordingTap> m_tap;
    session::Recording m_recording;
    std::shared_ptr<session::RecordingTap> m_experimentTap;
    Experiments m_experiments;
    SnapshotRecorder m_snapshotRecorder{
        m_device, m_recording, m_snapshots, [this] { return m_recorder.now(); }};
    session::SessionThread m_thread; // last: ends first, while the device it tells still exists
};

} // namespace widgets
