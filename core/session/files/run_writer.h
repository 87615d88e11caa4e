// Writes one run into a run book: its recording entry by entry, then the registers, then what came of it. A run that
// cannot be written whole leaves no file, and nothing that is there is overwritten.
//
// Call order: begin(), add() as long as it succeeds, end().
#pragma once

#include "session/files/run.h"
#include "session/recording/file.h"
#include "snapshots/snapshot.h"

#include <memory>
#include <optional>

namespace session {

class RunWriter {
public:
    /// @param folder  made if it is not there. @param run  without its number, gains and result
    RunWriter(QString folder, Run run);
    ~RunWriter(); ///< of one that did not come to its end nothing stays

    /// The next number, and the file of the recording. @return  empty, or why not
    QString begin(const recorded::Begin &begin);
    bool add(recorded::Nanos at, const recorded::Entry &entry) { return m_file->add(at, entry); }
    /// Evaluates the recording, too. @return  the run, or why not
    Result<Run, QString> end(const std::optional<snapshots::Snapshot> &registers);

private:
    void evaluate();

    QString m_folder;
    Run m_run;
    std::unique_ptr<RecordingFile> m_file;
    bool m_made = false; ///< there are files of its own
};

} // namespace session
