// Device: what the window knows of the connection, and the only way by which its parts ask for something. It holds
// the newest of each thing a session tells; it decides nothing about motors and never touches a port.
//
// Facts come in through apply() and portChanged(); wishes leave as signals, which the workbench connects to a session
// (tests connect spies). Lives in the GUI thread.
#pragma once

#include "drive/event.h"
#include "drive/motion_limits.h"
#include "drive/wish.h"
#include "session/link/session.h"

#include <QObject>

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <set>

namespace widgets {

using Milliseconds = std::chrono::milliseconds;

class Device : public QObject {
    Q_OBJECT
public:
    explicit Device(QObject *parent = nullptr);

    bool portOpen() const { return m_port == session::PortState::Open; }
    session::PortError portError() const { return m_portError; }
    drive::LinkChanged link() const { return m_link; }
    /// Connected in the sense that what is shown can be believed.
    bool answering() const { return m_link.state == drive::LinkState::Connected; }
    const session::Endpoint &endpoint() const { return m_endpoint; }

    /// What the board said of itself; empty until it has.
    const std::optional<drive::Identified> &identified() const { return m_identified; }
    std::shared_ptr<const catalog::Catalog> catalog() const;
    drive::StreamLimits streamLimits() const;
    /// Whether the board has a feature; the reason is for a tool tip and comes from core.
    drive::Capability capability(drive::Feature feature) const;

    int motor() const { return m_motor; } ///< the one the panels act on, from 1
    drive::MotorStatus status(int motor) const; ///< Unknown if nothing was heard
    /// The board answers, and has told its state since it last did not: what is shown of it can be believed.
    bool statusIsNow(int motor) const { return answering() && m_told.contains(motor); }
    bool allIdle() const; ///< true if no motor is known to be anywhere but idle or in a fault
    bool armed() const { return m_armed; }
    /// Set-points travel with every exchange.
    bool cyclicSetPoints() const { return m_cyclicSetPoints; }
    /// The user's own limits, and what may be asked of a motor under them: what the drive enforces.
    const drive::UserLimits &userLimits() const { return m_userLimits; }
    drive::MotionBounds bounds(int motor) const;
    drive::MotorLimits limits(int motor) const; ///< as the board tells them; zeros if not known
    double fullScaleAmps(int motor) const; ///< of the currents; 0: not known
    bool expert(int motor) const { return m_expert.contains(motor); }
    const drive::LinkCounters &counters() const { return m_counters; }
    /// Samples that only the display did not get, since the port was opened.
    std::uint64_t droppedForDisplay() const { return m_dropped; }

    /// Sends a wish and returns its id, which the matching `ended` carries.
    drive::WishId submit(decltype(drive::Wish::what) what);
    /// Tells when the act of the user that is being done was made; without it wishes are as old as their submission.
    void setActClock(std::function<TimePoint()> clock) { m_actClock = std::move(clock); }
    std::optional<TimePoint> madeAt() const; ///< that act; empty: nothing tells

public Q_SLOTS:
    void open(const session::Endpoint &endpoint);
    void close() { Q_EMIT closeWished(); }
    /// Every motor, ahead of everything; also disarms at once. Without an open port it is kept for one that is being
    /// opened, or opened again; where there is none nothing can carry it.
    void stop();
    void setArmed(bool armed);
    void setMotor(int motor);
    void setUserLimits(const drive::UserLimits &limits); ///< ignored if they bound nothing sensibly
    /// What the user knows of a motor's current scale; the board is told of anew (identityChanged) if it is taken.
    drive::WishId setCurrentScale(int motor, double fullScaleAmps);
    /// The user has agreed to move a motor whose board does not tell its limits.
    void becomeExpert(int motor);

    void apply(const session::BatchPtr &batch);
    void portChanged(session::PortState state, const session::PortError &why);
    void armedChanged(bool armed);

Q_SIGNALS:
    // Toward the session.
    void openWished(const session::Endpoint &endpoint);
    void closeWished();
    void wishMade(const drive::Wish &wish);
    void stopWished();
    void stopImpossible(); ///< no port is open: nothing can carry a stop now
    void forgetStopWished(); ///< the user takes back the stops that are still wanted somewhere
    void armWished(bool armed, std::optional<TimePoint> madeAt);
    void held(int motor); ///< what moves it is held now; again and again, for as long as it is
    void released();

    // Toward the panels.
    void portStateChanged();
    void linkStateChanged();
    void identityChanged();
    void statusChanged(int motor);
    void motorChanged();
    void boundsChanged(); ///< the user's limits, or expert mode
    void armedStateChanged(bool armed);
    void readingsArrived(const std::vector<drive::Reading> &readings);
    void wishEnded(const drive::Ended &ended);
    void streamStarted(const capture::StreamLayout &layout);
    void cyclicSetPointsChanged();
    void samplesArrived(const capture::SampleBlock &block);
    void stopAdvanced(const drive::StopProgress &progress);
    /// Ports at which a stop is wanted, and that are not open.
    void stopsWanted(const QStringList &ports);
    void interrupted(const session::Interruption &what); ///< what went on without the window
    void motionLogged(const drive::MotionEntry &entry);
    void countersChanged();
    void batchApplied();

private:
    void accept(const drive::Event &event);
    void onEnd(const drive::Ended &ended);
    void forgetBoard();
    void disarm();

    session::Endpoint m_endpoint;
    session::PortState m_port = session::PortState::Closed;
    session::PortError m_portError;
    drive::LinkChanged m_link;
    std::optional<drive::Identified> m_identified;
    std::map<int, drive::MotorStatus> m_status;
    std::set<int> m_told; ///< motors whose state is not of before a silence
    drive::UserLimits m_userLimits;
    std::set<int> m_expert;
    std::map<drive::WishId, int> m_expertWished; ///< motor by wish, not ended
    drive::LinkCounters m_counters;
    std::uint64_t m_dropped = 0;
    std::function<TimePoint()> m_actClock;
    drive::WishId m_lastWish = 0;
    int m_motor = 1;
    bool m_armed = false;
    bool m_cyclicSetPoints = false;
};

/// What is connected is a recording: nothing of it can turn, be written or be armed.
inline bool replaying(const Device &device)
{
    return device.endpoint().kind == session::Endpoint::Kind::Trace;
}

} // namespace widgets
