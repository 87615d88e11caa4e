// Replay: what the user has of a replay: pace and pause, how far it is, what happened. A replay itself is a
// recorded::ReplayDrive behind a session, like a board; replaying() puts it there.
//
// It is made for one receiver, which says what it has taken: until then the replay waits, so that a session never has
// to thin what a slow receiver cannot bear.
#pragma once

#include "recorded/replay_drive.h"
#include "session/link/session.h"

#include <QMetaType>
#include <QObject>

#include <atomic>
#include <memory>

namespace session {

struct ReplayState {
    QString path;
    double seconds = 0.0; ///< recorded, that were told
    double fraction = 0.0; ///< of the file
    std::uint64_t damagedPlaces = 0;
    bool ended = false;
};

/// Something that was recorded and is no event of a drive; times are on the session's axis.
struct ReplayedEntry {
    double seconds = 0.0;
    recorded::Entry entry;
};

class Replay : public QObject, public recorded::ReplayControl {
    Q_OBJECT
public:
    // In any thread.
    void setSpeed(double speed) { m_speed = speed; } ///< 0: as fast as it is taken
    double speed() const { return m_speed; }
    void setPaused(bool paused) { m_paused = paused; }
    bool paused() const { return m_paused; }
    /// Goes to a place in the file: on as fast as it is taken, back by beginning anew behind what was told.
    void seek(double fraction) { m_seek = fraction; }
    void accept(std::uint64_t values) { m_untaken -= static_cast<std::int64_t>(values); }

    // In the session's thread.
    void begin(const QString &path);
    recorded::ReplayPace pace() const override { return {m_speed, m_paused}; }
    bool full() const override { return m_untaken > 0; }
    std::optional<std::uint64_t> takeSeek() override;
    void handed(std::uint64_t values) override { m_untaken += static_cast<std::int64_t>(values); }
    void told(recorded::Nanos at, const recorded::Entry &entry) override;
    void progressed(const recorded::ReplayProgress &progress) override;

Q_SIGNALS:
    void advanced(const session::ReplayState &state); ///< ten times a second
    void happened(const session::ReplayedEntry &entry);

private:
    static constexpr double kNowhere = -1.0;
    std::atomic<double> m_speed = 1.0;
    std::atomic<bool> m_paused = false;
    std::atomic<double> m_seek = kNowhere; ///< part of the file
    std::atomic<std::int64_t> m_untaken = 0;
    ReplayState m_state; ///< of the session's thread
    double m_bytes = 1.0;
};

/// A trace that is a recording of ours.
bool isReplay(const Endpoint &endpoint);

/// Parts whose replays keep the pace of `replay`; others are as they were.
Parts replaying(const Parts &parts, const std::shared_ptr<Replay> &replay);

} // namespace session

Q_DECLARE_METATYPE(session::ReplayState)
Q_DECLARE_METATYPE(session::ReplayedEntry)
