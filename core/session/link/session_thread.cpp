#include "session/link/session_thread.h"

#include "session/link/session.h"

#include <QThread>

namespace session {

namespace {
constexpr unsigned long kMostWait_ms = 3000;
constexpr unsigned long kLastWait_ms = 1000; ///< for a session that was told to quit
} // namespace

SessionThread::SessionThread()
    : SessionThread(realParts())
{
}

SessionThread::SessionThread(Parts parts)
    : m_thread(new QThread)
    , m_session(new Session(std::move(parts)))
{
    m_thread->setObjectName(QStringLiteral("session"));
    m_session->moveToThread(m_thread);
    QObject::connect(m_thread, &QThread::finished, m_session, &QObject::deleteLater);
    m_thread->start();
}

SessionThread::~SessionThread()
{
    Session *session = m_session;
    QThread *thread = m_thread;
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
    if (!thread->wait(kMostWait_ms)) {
        thread->quit();
        if (!thread->wait(kLastWait_ms)) {
            QObject::connect(thread, &QThread::finished, thread, &QObject::deleteLater);
            return;
        }
    }
    delete thread;
}

} // namespace session
