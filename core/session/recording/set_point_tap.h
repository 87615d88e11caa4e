// SetPointTap: tells when the set-points of a session left for the board, whoever asked for them: a person, or an experiment.
#pragma once

#include "drive/set_points/set_point_times.h"
#include "session/recording/session_tap.h"

#include <QObject>

namespace session {

class SetPointTap : public QObject, public SessionTap {
    Q_OBJECT
public:
    void onEvent(const drive::Event &event, TimePoint now) override
    {
        if (const auto sent = m_times.onEvent(event, now))
            Q_EMIT left(*sent);
    }
    void onWish(const drive::Wish &wish, TimePoint) override { m_times.onWish(wish); }
    void onStop(TimePoint) override { }
    void onLink(record::LinkBytes::Direction direction, ByteView, TimePoint now) override
    {
        direction == record::LinkBytes::Direction::Sent ? m_times.onSent(now)
                                                        : m_times.onReceived(now);
    }

Q_SIGNALS:
    void left(const drive::SentSetPoint &sent); ///< connect it queued

private:
    drive::SetPointTimes m_times; ///< of the session's thread
};

} // namespace session
