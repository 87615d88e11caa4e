// Session: owns a transport and a drive, and is the only place that reads the clock and has a
// timer. It can live in a worker thread (the window) or in the main thread (the command line):
// every slot may be called queued.
//
// What the drive tells is handed on in batches: at most one every 16 ms, and never more than two
// that the receiver has not acknowledged, so a flooded link never floods an event loop. Beyond a
// bound, of the readings that wait the newest of each register stays, and samples are dropped for
// display only, counted, and shown as gaps.
//
// A port that is unplugged is told once, with portChanged(Closed, why), and all wishes end. Then
// the session tries to open it again every 500 ms until it succeeds or close() is called
// (Endpoint::reopen). The board is met read-only again; only streaming and watching are taken up by
// themselves, never a set-point, a start or an acknowledgement. The user's limits are given to each
// drive before it connects, also if they were set while no port was open.
//
// A stop is wanted until there is evidence that nothing drives a motor at that port, or the user takes it back: across
// lost ports, attempts to open them again, and connections to others. While one is wanted, the first act on any port
// that is opened is to stop what is there; only what is found at its own port confirms it. Asked for while the port is
// being closed, or open still when it is to be closed, a stop is carried out first, for two seconds at most.
//
// A guardian, where there is one, is told what stops the motors before anything leaves that can move one, and that the
// session lives with every turn. If it has acted, this program did not run for seconds: nothing of before is sent any
// more, and the port is opened anew like one that was unplugged.
//
// An experiment (lab/runner.h) is carried out between the drive and its callers: it sees each event first, and what
// breaks its envelope stops every motor within the same turn. Its wishes take the same way as others. A user who stops,
// disarms or commands the motor meanwhile ends it. Where nothing bounds the motor any more then, as in torque control,
// every motor is stopped first, and what the user asked for is not sent. Whichever way it ends, what was streamed and
// watched before is again.
//
// It is armed only as long as the user can see and stop what it does (session/link/dead_man.h): the interface stamps it
// with attendFromAnyThread(). A gap in time (session/link/time_gap.h) disarms, and the states of the motors are read
// before anything else. What followed of either is told by interrupted(), when the user is back.
#pragma once

#include "drive/drive.h"
#include "session/link/batcher.h"
#include "session/link/dead_man.h"
#include "session/link/driven_motors.h"
#include "session/link/guardian.h"
#include "session/link/outbox.h"
#include "session/link/time_gap.h"
#include "session/link/wake_timer.h"
#include "session/link/wanted_stops.h"
#include "session/transports/endpoint.h"
#include "session/transports/transport.h"

#include <QObject>

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace lab {
struct Experiment;
struct Outcome;
class Runner;
} // namespace lab

Q_MOC_INCLUDE("lab/experiment.h")

namespace session {

class SessionTap;

enum class PortState : std::uint8_t { Closed, Open };

/// What a session is made of. The tests bring a clock of their own, and transports and drives that
/// they can see into.
struct Parts {
    Clock clock; ///< monotonic
    std::function<std::unique_ptr<Transport>(const Endpoint &)> transport;
    std::function<std::unique_ptr<drive::Drive>(const Endpoint &)> drive;
    std::shared_ptr<Guardian> guardian = {}; ///< nullptr: none
    /// Goes on while the computer sleeps; may be called from any thread. Empty: the clock above, which then may be,
    /// too.
    Clock elapsed = {};
    /// Unless told otherwise, the session counts as unattended without signs of life.
    Attendance attendance = Attendance::Stamped;
    /// Each hears what goes to the drive and its line and what comes of them, in the session's thread.
    std::vector<std::shared_ptr<SessionTap>> taps = {};
};

/// The real ones: the monotonic clock, makeTransport(), drive::makeDrive(), elapsedTime(); stamped.
Parts realParts();

class Session : public QObject {
    Q_OBJECT
public:
    explicit Session(QObject *parent = nullptr);
    explicit Session(Parts parts, QObject *parent = nullptr);
    ~Session() override;

    /// From any thread: a stop that does not queue behind other calls. Same as the slot stop().
    void stopFromAnyThread();
    /// The interface is alive: some times a second, from one other thread (or from this one).
    void attendFromAnyThread() { m_stamps.attend(m_elapsed()); }
    /// What moves a motor is really held now, e.g. a button; again and again, from the interface's thread. Where it is
    /// not heard of for 300 ms without a release the motor is stopped.
    void holdFromAnyThread(int motor) { m_stamps.hold(motor, m_elapsed()); }
    void releaseFromAnyThread() { m_stamps.release(); }

    /// One turn of the pump: what the timer does. Early or repeated calls do nothing.
    void step(TimePoint now);
    /// When step() has something to do; empty: only the port or a call can change anything.
    std::optional<TimePoint> nextStep() const;
    /// No port, and no attempts to open one again.
    bool closed() const { return m_phase == Phase::Closed; }

public Q_SLOTS:
    /// Opens the port and connects; an open one is closed first.
    void open(const session::Endpoint &endpoint);
    /// Ends streaming, closes the port, ends with portChanged(Closed), within 300 ms, or after an open stop. Nothing if
    /// closed() already.
    void close();
    void submit(const drive::Wish &wish);
    void stop(); ///< every motor, ahead of everything
    /// The user's word: no stop is wanted at any port; what is under way goes on.
    void forgetStop();
    /// @param madeAt  when the user did what asked for it; too long ago: it is not armed
    void setArmed(bool armed, std::optional<TimePoint> madeAt = {});
    /// Stops every motor if the user has armed here and has not left them to turn: what a program does that is asked to
    /// end. Otherwise nothing.
    void stopOwn();
    void acknowledge(); ///< one batch has been taken in
    /// Carries out an experiment; exactly one experimentEnded() follows. Refused while another one runs, or where the
    /// drive is not armed.
    void run(const lab::Experiment &experiment);

Q_SIGNALS:
    void batch(const session::BatchPtr &batch);
    void portChanged(session::PortState state, const session::PortError &why);
    void armedChanged(bool armed);
    /// The ports at which a stop is wanted and cannot be carried out now, because they are not open.
    void stopsWanted(const QStringList &ports);
    void interrupted(const session::Interruption &what);
    void experimentEnded(const lab::Outcome &outcome);

protected:
    bool event(QEvent *event) override;

private:
    enum class Phase : std::uint8_t {
        Closed,
        Open,
        LastStop, ///< to be closed; but first the stop that is open, until m_deadline at the latest
        Closing, ///< the drive says its last words, until m_deadline at the latest
        Reopening, ///< unplugged; the next attempt is at m_deadline
    };

    TimePoint wake();
    void lookUp(TimePoint now);
    void arm(TimePoint madeAt, TimePoint now);
    void disarm(TimePoint now);
    void openNow(const Endpoint &endpoint, TimePoint now);
    PortError tryOpen(TimePoint now);
    void onReceived(const QByteArray &bytes);
    void onFailed(const PortError &error);
    void onReady(bool high);
    void gather(TimePoint now);
    void reopen(TimePoint now);
    void runLink(TimePoint now);
    void submitToDrive(drive::Wish wish, TimePoint now);
    void stopDrive(TimePoint now);
    void exchange(TimePoint now);
    void collectEvents(TimePoint now);
    void takeUpAgain(TimePoint now);
    void afterFailure(TimePoint now);
    void startClosing();
    void finishClosing();
    void dropLink();
    void openNext();
    void stopNow(TimePoint now);
    bool runExperiment(TimePoint now);
    void interruptExperiment(const std::string &why, TimePoint now);
    bool stopForExperiment(TimePoint now);
    void endExperiment(TimePoint now);
    void settleStop();
    void tellGuardian(TimePoint now);
    bool handsOff() const; ///< the guardian acted: nothing may be sent
    void yieldPort(TimePoint now);
    void tell(TimePoint now);
    void tellRest();
    void tellArmed();
    void tellStops();
    void armTimer(TimePoint now);
    bool linked() const
    {
        return m_phase == Phase::Open || m_phase == Phase::LastStop || m_phase == Phase::Closing;
    }

    Parts m_parts;
    Clock m_elapsed; ///< of the parts; shared by threads, and never changed
    Stamps m_stamps;
    DeadMan m_deadMan;
    TimeGap m_gap;
    std::optional<TimePoint> m_wakeDue; ///< the timer was set to it
    WakeTimer m_timer;
    TimePoint m_wokenAt{}; ///< by it
    Phase m_phase = Phase::Closed;
    TimePoint m_deadline{};
    Endpoint m_endpoint;
    std::optional<Endpoint> m_next; ///< to be opened when the one before is closed
    std::unique_ptr<Transport> m_transport;
    std::unique_ptr<drive::Drive> m_drive;
    TimePoint m_heardAt{}; ///< the drive heard of its line
    Outbox m_outbox{1};
    Duration m_gathers{}; ///< so late may be told what comes, and that all has left
    Batcher m_batcher;
    std::optional<PortError> m_failure; ///< reported by the transport, not yet acted upon
    std::optional<drive::Stream> m_stream; ///< last asked for; taken up again after a reopening
    std::optional<drive::Watch> m_watch;
    std::optional<drive::UserLimits> m_limits; ///< the user's; for every drive from then on
    WantedStops m_stops;
    std::unique_ptr<lab::Runner> m_experiment;
    std::optional<TimePoint> m_ranAt; ///< a motor was last seen not to be idle
    QStringList m_stopsTold;
    TimePoint m_stopUntil{}; ///< closing waits so long for a stop that is open
    std::map<QString, drive::LineMemory> m_memory; ///< by path
    DrivenMotors m_driven; ///< also from one connection to the next
    TimePoint m_stampedAt{};
    std::optional<TimePoint> m_yieldBy; ///< the guardian sends until then, at the longest
    std::atomic<bool> m_stopRequested = false;
    bool m_stepping = false;
    bool m_saidFarewell = false; ///< Closing: the drive has told that its link is closed
    bool m_takeUpAgain = false; ///< reopened: streaming goes on once the board is identified
    bool m_armed = false; ///< as last told
};

} // namespace session

Q_DECLARE_METATYPE(session::BatchPtr)
Q_DECLARE_METATYPE(session::PortState)
Q_DECLARE_METATYPE(session::Interruption)
Q_DECLARE_METATYPE(drive::Wish)
