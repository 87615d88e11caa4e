// Opening a recording from a disk: read in a thread of the pool, into a capture of its own, so that a file that cannot
// be read leaves everything as it was.
#pragma once

#include "capture/capture.h"
#include "session/recording/reader.h"
#include "session/recording/replay.h"

#include <QObject>

#include <map>
#include <optional>

namespace widgets {

class EventLog;
class FileJob;

struct OpenedRecording {
    QString path;
    capture::Capture capture;
    session::RecordingReport report;
};

constexpr std::size_t kMostMemoryOfFile = 4'000'000'000; ///< of the samples of a file

/// Reads it and calls `take` in the GUI thread, or `fail` with a sentence; nothing if it was cancelled.
/// @param config  of the capture; where it has no room the oldest samples are let go, which is told
FileJob *openRecording(const QString &path, QWidget *window,
    std::function<void(OpenedRecording &)> take, std::function<void(const QString &)> fail,
    capture::Capture::Config config = {.maxBytes = kMostMemoryOfFile});

/// One sentence: what was opened and what is missing from it. True in `whole` if nothing is.
QString openedText(const OpenedRecording &opened, bool &whole);

/// That the oldest samples of a file had no room in memory; empty if all are there.
QString releasedText(const capture::Capture &capture);

/// What happened during the recording and the marks in it.
void fillEvents(EventLog &events, const session::RecordingReport &report);

/// The same for one thing of a replay.
void addReplayed(EventLog &events, const session::ReplayedEntry &entry);

/// Of a replay: the writes that the board took, at the time they were asked for, as those of a connection.
class ReplayedWrites {
public:
    struct Write {
        double seconds = 0.0; ///< when it was asked for
        QStringList names; ///< of the registers that took it
    };
    /// The write that this entry says was taken; empty if it says no such thing.
    std::optional<Write> accept(const session::ReplayedEntry &entry);

private:
    std::map<std::string, double> m_asked; ///< by the number of the wish
};

} // namespace widgets
