// RecordingWorker: writes the file of a Recording, in the recorder's thread. Private to Recording.
#pragma once

#include "session/recording/recording.h"

#include <QElapsedTimer>
#include <QTimer>

#include <atomic>

namespace session {

/// What was told and is not written yet: a stack that one thread puts on and another takes whole, without a lock.
class Inbox {
public:
    ~Inbox() { (void)take(); }
    void put(ToldPtr told); ///< in the session's thread
    std::vector<ToldPtr> take(); ///< in the recorder's thread; the earliest first

private:
    struct Sheet {
        ToldPtr told;
        Sheet *below = nullptr;
    };
    std::atomic<Sheet *> m_top = nullptr;
};

class RecordingWorker : public QObject {
    Q_OBJECT
public:
    RecordingWorker(std::shared_ptr<RecordingTap> tap, RecordingLimits limits, MakeSink makeSink);

    void start(const QString &path, RecordingTap::Content content, const recorded::Begin &begin);
    void stop();
    void add(recorded::Nanos at, const recorded::Entry &entry);

Q_SIGNALS:
    void started(const QString &path);
    void progressed(const session::RecordingProgress &progress);
    void finished(const session::RecordingResult &result);

private:
    void processAll();
    void accept(const ToldPtr &told);
    void tick();
    void finish();
    RecordingProgress progress();

    std::shared_ptr<RecordingTap> m_tap;
    /// Looked into four times a second: woken for each packet, 250 times, a thread computes several times as much.
    std::shared_ptr<Inbox> m_inbox = std::make_shared<Inbox>();
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
    recorded::Lost m_lost;
    recorded::Coverage m_coverage;
    unsigned m_number = 0;
};

} // namespace session
