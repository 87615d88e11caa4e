#include "session/recording/recording.h"

#include "session/recording/worker.h"

namespace session {

Recording::Recording(
    std::shared_ptr<RecordingTap> tap, RecordingLimits limits, MakeSink makeSink, QObject *parent)
    : QObject(parent)
    , m_tap(std::move(tap))
    , m_worker(new RecordingWorker(m_tap, limits, std::move(makeSink)))
{
    qRegisterMetaType<RecordingProgress>("session::RecordingProgress");
    qRegisterMetaType<RecordingResult>("session::RecordingResult");
    m_thread.setObjectName(QStringLiteral("recorder"));
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    connect(m_worker, &RecordingWorker::started, this, &Recording::started);
    connect(m_worker, &RecordingWorker::progressed, this, &Recording::progressed);
    connect(m_worker, &RecordingWorker::finished, this, [this](const RecordingResult &result) {
        m_running = false;
        Q_EMIT finished(result);
    });
    m_thread.start();
}

Recording::~Recording()
{
    stop();
    QMetaObject::invokeMethod(
        m_worker, [this] { m_thread.quit(); }, Qt::QueuedConnection);
    m_thread.wait();
}

void Recording::start(const QString &path, RecordingTap::Content content, const QString &program,
    const QString &source)
{
    if (m_running)
        return;
    m_running = true;
    m_ending = false;
    const recorded::Begin begin{m_tap->startSeconds(), program.toStdString(), source.toStdString()};
    QMetaObject::invokeMethod(
        m_worker, [=, worker = m_worker] { worker->start(path, content, begin); },
        Qt::QueuedConnection);
}

void Recording::stop()
{
    if (!m_running)
        return;
    m_ending = true;
    QMetaObject::invokeMethod(
        m_worker, [worker = m_worker] { worker->stop(); }, Qt::QueuedConnection);
}

bool Recording::add(recorded::Nanos at, recorded::Entry entry)
{
    if (!m_running || m_ending)
        return false;
    QMetaObject::invokeMethod(
        m_worker, [worker = m_worker, at, what = std::move(entry)] { worker->add(at, what); },
        Qt::QueuedConnection);
    return true;
}

} // namespace session
