// Notes in the event log what the user asked of the board and what the board told, on the clock of the samples. It
// listens to the Device only, asks for nothing and decides nothing.
#pragma once

#include "capture/capture.h"
#include "drive/set_points/times.h"
#include "widgets/base/device.h"
#include "widgets/scope/events/log.h"

#include <functional>
#include <map>
#include <optional>
#include <utility>

namespace widgets {

/// The session's clock as the window can know it: from the stamps of what arrives, which are some milliseconds old.
class SessionClock {
public:
    /// @return  whether it belongs to another clock than those before
    bool stamped(TimePoint at, Milliseconds now);
    double secondsAt(Milliseconds now) const; ///< on the session's axis

private:
    std::optional<double> m_lag; ///< seconds that the window's clock is ahead of the session's
};

class EventRecorder : public QObject {
    Q_OBJECT
public:
    /// All outlive it.
    EventRecorder(Device &device, const capture::Capture &capture, EventLog &log,
        std::function<Milliseconds()> now, QObject *parent = nullptr);

    double now() const; ///< seconds on the session's axis, which is that of recordings
    double samplesNow() const { return m_axis.of(now()); } ///< on the axis of the samples
    /// Its line tells from now on how exactly its instant is known.
    void left(drive::WishId wish, double within_s);
    void replaced(); ///< another board has answered than before
    void noteExperiment(TimePoint at, const QString &text);
    void stored(const capture::SampleBlock &block); ///< it is in the capture

    /// What was asked for, in words; empty for what is no command. @param several  motors, which are told apart
    static QString wishText(const drive::Wish &wish, bool several);
    static QString motorText(int motor, const QString &text, bool several);

Q_SIGNALS:
    // The same for a trigger that waits for it; `seconds` on the axis of the samples.
    void stateChanged(double seconds, widgets::EventKind kind, quint32 which); ///< State or Fault
    void faulted(double seconds, int motor, const QString &fault); ///< its name, fit to be shown
    void written(double seconds, const QString &name); ///< of a register

private:
    struct Asked {
        double seconds = 0.0;
        quint32 event = 0; ///< in the log; 0: a write, noted when it has ended
    };
    enum class Trouble : std::uint8_t { Recovering, Silent, Lost, Port }; ///< the later, the worse
    struct Loss {
        Trouble how;
        quint32 id; ///< its line
        double since; ///< on the session's axis
    };
    void stamped(TimePoint at);
    double onAxis(TimePoint at) const;
    void hear();
    void noteLoss(Trouble how, const QString &text);
    void note(EventKind kind, double seconds, const QString &text);
    void wished(const drive::Wish &wish);
    void ended(const drive::Ended &ended);
    void wrote(const drive::WriteResult &write, double seconds);
    void status(int motor);
    void acted(const drive::MotionEntry &entry);
    bool pastIsNew(const drive::MotorStatus &now);
    void link();
    void port();
    QString named(int motor, const QString &text) const;
    bool severalMotors() const;

    Device &m_device;
    const capture::Capture &m_capture;
    EventLog &m_log;
    std::function<Milliseconds()> m_now;
    SessionClock m_clock;
    double m_origin = 0.0; ///< of the stream
    drive::SampleAxis m_axis; ///< a board's clock and the session's drift apart by seconds a day
    std::map<drive::WishId, Asked> m_asked;
    std::pair<drive::WishId, quint32> m_lastEnded; ///< a command, and its line
    std::map<int, drive::MotorStatus> m_status;
    std::map<int, TimePoint> m_acknowledged; ///< by motor: when the board had done so
    std::pair<drive::MotionAct, TimePoint> m_experimented{
        drive::MotionAct::Arm, {}}; ///< what the last one asked for, and when
    drive::LinkState m_link = drive::LinkState::Closed;
    std::optional<Loss> m_loss; ///< that goes on
    bool m_closing = false; ///< the link is closed, and its port has not told why
    double m_tickHz = 0.0;
};

} // namespace widgets
