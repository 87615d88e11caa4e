#include "session/csv_file.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QSaveFile>
#include <QThread>

namespace session {

namespace {
constexpr qint64 kProgressMs = 50;

CsvResult failed(CsvResult result, CsvError error, const QString &systemText)
{
    result.error = error;
    result.systemText = systemText;
    return result;
}

/// A short write is no success: commit() would put a truncated file in place (Qt 6.4). Only writing the rest tells why.
bool writeAll(QSaveFile &file, std::string_view text)
{
    while (!text.empty()) {
        const qint64 count = file.write(text.data(), static_cast<qint64>(text.size()));
        if (count <= 0)
            return false;
        text.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}
} // namespace

CsvResult writeCsvFile(
    const QString &path, capture::CsvWriter &writer, const std::function<bool(double)> &proceed)
{
    CsvResult result;
    result.path = path;
    // QSaveFile would put a file in the place of a device.
    const QFileInfo existing(path);
    if (existing.exists() && !existing.isFile())
        return failed(result, CsvError::NotAFile, {});
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
        return failed(result, CsvError::CannotOpen, file.errorString());
    std::string text;
    while (writer.next(text)) {
        if (!writeAll(file, text)) {
            const QString reason = file.errorString();
            file.cancelWriting();
            return failed(result, CsvError::CannotWrite, reason);
        }
        result.bytes += static_cast<qint64>(text.size());
        if (proceed && !proceed(writer.progress())) {
            file.cancelWriting();
            return failed(result, CsvError::Cancelled, {});
        }
    }
    if (!file.flush() || file.size() != result.bytes) {
        const QString reason = file.errorString();
        file.cancelWriting();
        return failed(result, CsvError::CannotWrite, reason);
    }
    if (!file.commit())
        return failed(result, CsvError::CannotReplace, file.errorString());
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
