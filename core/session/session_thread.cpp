#include "session/session_thread.h"

#include "session/session.h"

namespace session {

namespace {
constexpr unsigned long kMostWait_ms = 2000;
} // namespace

SessionThread::SessionThread()
    : SessionThread(realParts())
{
}

SessionThread::SessionThread(Parts parts)
    : m_session(new Session(std::move(parts)))
{
    m_thread.setObjectName(QStringLiteral("session"));
    m_session->moveToThread(&m_thread);
    QObject::connect(&m_thread, &QThread::finished, m_session, &QObject::deleteLater);
    m_thread.start();
}

SessionThread::~SessionThread()
{
    Session *session = m_session;
    QThread *thread = &m_thread;
    QMetaObject::invokeMethod(
        session,
        [session, thread] {
            QObject::connect(
                session, &Session::portChanged, thread,
                [thread](PortState state) {
                    if (state == PortState::Closed)
                        thread->quit();
                },
                Qt::DirectConnection);
            session->close();
            if (session->closed())
                thread->quit();
        },
        Qt::QueuedConnection);
    if (m_thread.wait(kMostWait_ms))
        return;
    m_thread.quit();
    m_thread.wait();
}

} // namespace session
