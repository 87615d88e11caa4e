#include "session/csv_file.h"

#include <QElapsedTimer>
#include <QThread>

namespace session {

namespace {
constexpr qint64 kProgressMs = 50;

} // namespace

CsvResult writeCsvFile(
    const QString &path, capture::CsvWriter &writer, const std::function<bool(double)> &proceed)
{
    const FileResult file = writePieces(
        path, [&writer](std::string_view &text) { return writer.next(text); },
        [&] { return !proceed || proceed(writer.progress()); });
    CsvResult result;
    result.error = file.error;
    result.path = path;
    result.systemText = file.systemText;
    result.bytes = file.bytes;
    if (file.error == CsvError::None)
        result.rows = writer.rows();
    return result;
}

CsvExport::CsvExport(
    QString path, capture::Snapshot channels, capture::CsvOptions options, QObject *parent)
    : QObject(parent)
    , m_path(std::move(path))
    , m_channels(std::move(channels))
    , m_options(options)
{
}

CsvExport::~CsvExport()
{
    m_cancelled = true;
    if (m_thread)
        m_thread->wait();
}

void CsvExport::start()
{
    if (m_thread)
        return;
    m_thread.reset(QThread::create([this] { runInThread(); }));
    m_thread->start();
}

void CsvExport::cancel() { m_cancelled = true; }

/// In the worker thread. It reads the immutable snapshot and the atomic flag, and posts values back; the destructor
/// waits for it, so the object outlives it.
void CsvExport::runInThread()
{
    capture::CsvWriter writer(m_channels, m_options);
    QElapsedTimer sinceProgress;
    sinceProgress.start();
    const CsvResult result = writeCsvFile(m_path, writer, [&](double fraction) {
        if (sinceProgress.elapsed() >= kProgressMs) {
            sinceProgress.start();
            QMetaObject::invokeMethod(
                this, [this, fraction] { Q_EMIT progressed(fraction); }, Qt::QueuedConnection);
        }
        return !m_cancelled;
    });
    QMetaObject::invokeMethod(
        this,
        [this, result] {
            m_over = true;
            Q_EMIT finished(result);
        },
        Qt::QueuedConnection);
}

} // namespace session
