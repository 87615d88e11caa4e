// Opening a recording for a command, and recording while one runs.
#pragma once

#include "conversation.h"
#include "session/recording/reader.h"
#include "session/recording/recording.h"
#include "snapshots/snapshot.h"

namespace cli {

struct OpenedRecording {
    capture::Capture capture;
    session::RecordingReport report;
};

/// The whole recording, on a disk what memory has no room for; a failure if the file holds none.
Outcome<std::unique_ptr<OpenedRecording>> openRecording(const QString &path);

struct ImportedCsv {
    capture::Capture capture;
    std::uint64_t leftOut = 0; ///< rows that have the time of the row before
};

/// A CSV file of ours, of PlotJuggler or of VESC Tool; a failure that names line and column if it is none.
Outcome<std::unique_ptr<ImportedCsv>> importCsv(const QString &path);

/// The sentence about what of it is left out; empty if all is there.
QString lackText(const ImportedCsv &csv);

/// And about what a damaged or interrupted recording lacks; empty if it is whole.
QString lackText(const OpenedRecording &recording);

/// A failure if the name is not that of a recording: a file called .csv would be taken for a table.
Outcome<bool> checkRecordingName(const QString &path);

/// What sentences call a recording. @param kept  else its file goes with the program, and its path says nothing
QString recordingName(const QString &path, bool kept);

/// A recording of a conversation, as capture --record makes it.
class ConversationRecording {
public:
    ConversationRecording(Conversation &talk, const QString &path, bool withLink, bool kept = true);

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
    bool m_withLink, m_kept;
    session::Recording m_recording;
    bool m_started = false;
    std::optional<session::RecordingResult> m_result;
    session::RecordingProgress m_last;
};

} // namespace cli
