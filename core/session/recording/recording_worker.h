// RecordingWorker: writes the file of a Recording, in the recorder's thread. Private to Recording.
#pragma once

#include "session/recording/recording.h"

#include <QElapsedTimer>
#include <QTimer>

namespace session {

class RecordingWorker : public QObject {
    Q_OBJECT
public:
    RecordingWorker(std::shared_ptr<RecordingTap> tap, RecordingLimits limits, MakeSink makeSink);

    void start(const QString &path, RecordingTap::Content content, const record::Begin &begin);
    void stop();
    void add(record::Nanos at, record::Entry entry);

Q_SIGNALS:
    void started(const QString &path);
    void progressed(const session::RecordingProgress &progress);
    void finished(const session::RecordingResult &result);

private:
    void take(const ToldPtr &told);
    void tick();
    void finish();
    RecordingProgress progress();

    std::shared_ptr<RecordingTap> m_tap;
    RecordingLimits m_limits;
    MakeSink m_makeSink;
    std::unique_ptr<RecordingFile> m_file;
    QTimer m_timer;
    QElapsedTimer m_sinceSync;
    QElapsedTimer m_sinceRate;
    std::uint64_t m_bytesThen = 0; ///< when the rate was taken last
    double m_rate = 0.0;
    qint64 m_free = -1; ///< bytes on the disk, at the last sync
    QString m_path;
    record::Lost m_lost;
    record::Coverage m_coverage;
    unsigned m_number = 0;
};

} // namespace session
