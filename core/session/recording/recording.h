// Recording: the face of a recording for the window and the command line. The file is written in a thread of its own,
// from what a RecordingTap tells: neither the link nor the window ever waits for a disk.
//
// Call order: start(), anything, stop(); then start() again. After start() either started() comes or finished(); after
// started() exactly one finished(), by stop() or because the disk wants no more.
#pragma once

#include "recorded/coverage.h"
#include "session/recording/file.h"
#include "session/recording/tap.h"

#include <QObject>
#include <QThread>

namespace session {

struct RecordingProgress {
    RecordingFile::Counts counts;
    double bytesPerSecond = 0.0; ///< over about the last second
    qint64 freeBytes = -1; ///< on the disk; negative: unknown
    qint64 roomBytes = -1; ///< of them for the recording, until RecordingLimits::endBytes are left
    bool lowSpace = false; ///< less than RecordingLimits::warnBytes
    recorded::Lost lost; ///< in all: what the disk was too slow for
};

enum class RecordingOutcome : std::uint8_t {
    Stopped, ///< as asked, and the file is whole
    CannotOpen, ///< nothing was recorded: the file is there already, or its folder takes none
    DiskFull, ///< the file ends where the disk was full
    WriteFailed, ///< the file ends where the disk failed
};

struct RecordingResult {
    RecordingOutcome outcome = RecordingOutcome::Stopped;
    QString path;
    QString systemText; ///< the system's words
    RecordingProgress last;
    recorded::Coverage coverage; ///< what of each signal is in it
    bool complete = false; ///< nothing that was told in that time is missing from it
};

struct RecordingLimits {
    qint64 warnBytes = 200'000'000; ///< free on the disk
    qint64 endBytes = 50'000'000; ///< the recording ends before others suffer
};

using MakeSink = std::function<std::unique_ptr<BlockSink>(const QString &, QString &)>;

class RecordingWorker;

class Recording : public QObject {
    Q_OBJECT
public:
    explicit Recording(std::shared_ptr<RecordingTap> tap, RecordingLimits limits = {},
        MakeSink makeSink = makeDiskSink, QObject *parent = nullptr);
    ~Recording() override; ///< ends the file and waits for that

    /// Makes the file, which must not be there yet. Nothing while one is running.
    void start(const QString &path, RecordingTap::Content content, const QString &program,
        const QString &source);
    void stop(); ///< finished() follows
    /// A note or a snapshot at this time of the session; false if it is in no file: none is running, or it is ending.
    bool add(recorded::Nanos at, recorded::Entry entry);
    bool running() const { return m_running; }

Q_SIGNALS:
    void started(const QString &path);
    void progressed(const session::RecordingProgress &progress); ///< four times a second
    void finished(const session::RecordingResult &result);

private:
    QThread m_thread;
    std::shared_ptr<RecordingTap> m_tap;
    RecordingWorker *m_worker; ///< lives in m_thread and ends with it
    bool m_running = false;
    bool m_ending = false; ///< stop() was called
};

} // namespace session

Q_DECLARE_METATYPE(session::RecordingProgress)
Q_DECLARE_METATYPE(session::RecordingResult)
