// SessionThread: a session in a thread of its own. What is asked of the session goes there by
// queued calls; only stopFromAnyThread() may be called directly.
#pragma once

class QThread;

namespace session {

class Session;
struct Parts;

class SessionThread {
public:
    SessionThread(); ///< with realParts()
    explicit SessionThread(Parts parts);
    SessionThread(const SessionThread &) = delete;
    SessionThread &operator=(const SessionThread &) = delete;
    /// Closes the port (an open stop and the end of streaming: 2.3 s at most), then ends the thread; waits 4 s at most.
    /// A thread that hangs for longer, in a driver, goes on without us: it must not be destroyed while it runs.
    ~SessionThread();

    Session *session() const { return m_session; }

private:
    QThread *m_thread; ///< left behind, running, where it does not end in time
    Session *m_session; ///< lives in m_thread and ends with it
};

} // namespace session
