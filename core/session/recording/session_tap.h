// SessionTap: what listens to a session, before anything is dropped for display: its drive and its line. It stands in the
// session's thread, never waits and changes nothing.
#pragma once

#include "record/entry.h"
#include "session/link/session.h"

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
    virtual void onLink(record::LinkBytes::Direction direction, ByteView bytes, TimePoint now) = 0;
};

/// Parts whose transports and drives tell the tap what they do.
Parts listened(const Parts &parts, const std::shared_ptr<SessionTap> &tap);

} // namespace session
