// SessionTap: what listens to a session, before anything is dropped for display: its drive and its line. It stands in
// the session's thread, never waits and changes nothing. SetPointTap is the one of them that tells set-points alone.
#pragma once

#include "drive/set_points/times.h"
#include "recorded/entry.h"
#include "session/link/session.h"

#include <QObject>

#include <memory>

namespace session {

class SessionTap {
public:
    SessionTap() = default;
    SessionTap(const SessionTap &) = delete;
    SessionTap &operator=(const SessionTap &) = delete;
    virtual ~SessionTap() = default;

    virtual void onEvent(const drive::Event &event, TimePoint now) = 0;
    virtual void onWish(const drive::Wish &wish, TimePoint now) = 0;
    virtual void onStop(TimePoint now) = 0;
    virtual void onLink(
        recorded::LinkBytes::Direction direction, ByteView bytes, TimePoint now) = 0;
};

/// Parts whose session tells the tap, too.
Parts listened(Parts parts, std::shared_ptr<SessionTap> tap);

/// Tells when the set-points of a session left for the board, asked for by the user or by an experiment; and from when
/// on what was sent holds no more.
class SetPointTap : public QObject, public SessionTap {
    Q_OBJECT
public:
    void onEvent(const drive::Event &event, TimePoint now) override
    {
        const auto news = m_times.onEvent(event, now);
        if (!news)
            return;
        if (const auto *sent = std::get_if<drive::SentSetPoint>(&*news))
            Q_EMIT left(*sent);
        else
            Q_EMIT ended(std::get<drive::SetPointsEnd>(*news));
    }
    void onWish(const drive::Wish &wish, TimePoint) override { m_times.onWish(wish); }
    void onStop(TimePoint now) override { Q_EMIT ended(m_times.onStop(now)); }
    void onLink(recorded::LinkBytes::Direction direction, ByteView, TimePoint now) override
    {
        direction == recorded::LinkBytes::Direction::Sent ? m_times.onSent(now)
                                                          : m_times.onReceived(now);
    }

Q_SIGNALS:
    void left(const drive::SentSetPoint &sent); ///< connect it queued
    void ended(const drive::SetPointsEnd &end); ///< likewise

private:
    drive::SetPointTimes m_times; ///< of the session's thread
};

} // namespace session
