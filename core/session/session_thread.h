// SessionThread: a session in a thread of its own. What is asked of the session goes there by
// queued calls; only stopFromAnyThread() may be called directly.
#pragma once

#include <QThread>

namespace session {

class Session;
struct Parts;

class SessionThread {
public:
    SessionThread(); ///< with realParts()
    explicit SessionThread(Parts parts);
    SessionThread(const SessionThread &) = delete;
    SessionThread &operator=(const SessionThread &) = delete;
    /// Closes the port (streaming ends, at most 300 ms), then ends the thread; waits 2 s for both
    /// at most.
    ~SessionThread();

    Session *session() const { return m_session; }

private:
    QThread m_thread;
    Session *m_session; ///< lives in m_thread and ends with it
};

} // namespace session
