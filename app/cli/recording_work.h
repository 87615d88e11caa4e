// Opening a recording for a command, and recording while one runs.
#pragma once

#include "conversation.h"
#include "session/recording/recording.h"
#include "session/recording/recording_reader.h"
#include "snapshots/snapshot.h"

namespace cli {

struct OpenedRecording {
    capture::Capture capture;
    session::RecordingReport report;
};

/// The whole recording, on a disk what memory has no room for; a failure if the file holds none.
Outcome<std::unique_ptr<OpenedRecording>> openRecording(const QString &path);

/// A CSV file of ours, of PlotJuggler or of VESC Tool; a failure that names line and column if it is none.
Outcome<std::unique_ptr<capture::Capture>> importCsv(const QString &path);

/// The sentence about samples that there was no room for; empty if all are there.
QString lackText(const capture::Capture &capture);

/// And about what a damaged or interrupted recording lacks; empty if it is whole.
QString lackText(const OpenedRecording &recording);

/// A recording of a conversation, as capture --record makes it.
class ConversationRecording {
public:
    ConversationRecording(Conversation &talk, const QString &path, bool withLink);

    Outcome<int> start(const QString &source);
    /// What the board holds.
    void add(TimePoint at, const snapshots::Snapshot &registers);
    void add(TimePoint at, const recorded::Happening &happening);
    /// Ends it, if it is not over already.
    /// @return  kDone; a failure if it ended early or something did not get into it
    Outcome<int> finish();
    const session::RecordingProgress &last() const { return m_last; }

private:
    Conversation &m_talk;
    QString m_path;
    bool m_withLink;
    session::Recording m_recording;
    bool m_started = false;
    std::optional<session::RecordingResult> m_result;
    session::RecordingProgress m_last;
};

} // namespace cli
