// Writes a capture as a CSV file: the file appears whole or not at all, and what was there before stays until then.
// The text itself is core/capture/csv_export.h; only whether the disk took it is decided here.
#pragma once

#include "capture/csv_export.h"
#include "session/piece_file.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <memory>

class QThread;

namespace session {

using CsvError = FileError;

struct CsvResult {
    CsvError error = CsvError::None;
    QString path;
    QString systemText; ///< the system's words for it, e.g. "No space left on device"
    quint64 rows = 0;
    qint64 bytes = 0;
};

/// Writes the whole file and returns when it is there, or the reason why it is not.
/// @param proceed  called with the progress 0..1 about every mebibyte; false cancels
CsvResult writeCsvFile(const QString &path, capture::CsvWriter &writer,
    const std::function<bool(double)> &proceed = {});

/// The same in a thread of its own, for the window. One export an object; make a new one for the next.
class CsvExport : public QObject {
    Q_OBJECT
public:
    CsvExport(QString path, capture::Snapshot channels, capture::CsvOptions options,
        QObject *parent = nullptr);
    ~CsvExport() override; ///< cancels and waits

    void start();
    void cancel(); ///< finished() follows, with Cancelled if it was not done before
    bool running() const { return m_thread != nullptr && !m_over; }

Q_SIGNALS:
    void progressed(double fraction); ///< 0..1, at most every 50 ms
    void finished(const session::CsvResult &result); ///< exactly once after start()

private:
    void runInThread();

    QString m_path;
    capture::Snapshot m_channels;
    capture::CsvOptions m_options;
    std::atomic<bool> m_cancelled{false};
    std::unique_ptr<QThread> m_thread;
    bool m_over = false;
};

} // namespace session
