// Opening a recording from a disk: read in a thread of the pool, into a capture of its own, so that a file that cannot be
// read leaves everything as it was.
#pragma once

#include "capture/capture.h"
#include "session/recording_reader.h"

#include <QObject>

namespace widgets {

class EventLog;
class FileJob;

struct OpenedRecording {
    QString path;
    capture::Capture capture;
    session::RecordingReport report;
};

/// Reads it and calls `take` in the GUI thread, or `fail` with a sentence; nothing if it was cancelled.
FileJob *openRecording(const QString &path, QWidget *window,
    std::function<void(OpenedRecording &)> take, std::function<void(const QString &)> fail);

/// One sentence: what was opened and what is missing from it. True in `whole` if nothing is.
QString openedText(const OpenedRecording &opened, bool &whole);

/// What happened during the recording and the marks in it.
void fillEvents(EventLog &events, const session::RecordingReport &report);

} // namespace widgets
