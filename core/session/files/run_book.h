// A run book: a folder that keeps every experiment as a run, in three files that stand for themselves:
// "run-0007.pcapng", its recording; "run-0007-registers.json", what could be tuned right behind it, a snapshot; and
// "run-0007.json", what it was and what came of it (docs/run-book.md). All of it looks at a disk, so it belongs into a
// job.
#pragma once

#include "lab/experiment.h"
#include "session/files/run.h"
#include "session/recording/tap.h"
#include "snapshots/snapshot.h"

#include <functional>
#include <optional>
#include <vector>

namespace session {

/// What is to be kept of an experiment that has ended.
struct EndedRun {
    recorded::Begin begin;
    std::vector<ToldPtr> told; ///< all of it, plans and ends too
    recorded::Happening plan; ///< the first
    lab::Outcome outcome;
    QString board, motorName;
    int motor = 1;
    qint64 at = 0;
    std::optional<snapshots::Snapshot> registers; ///< empty: they could not be read
};

/// Writes its files and evaluates its recording; it gets the next number. Or says why not, and then nothing of it
/// stays.
Result<Run, QString> keepRun(const QString &folder, const EndedRun &ended);

struct RunBook {
    std::vector<Run> runs; ///< by their number
    QStringList problems; ///< a sentence each, without a full stop: files that make no sense
};
/// @param proceed  as readRecording() has it; cancelled, what was read so far is given
/// @return  or the system's words, where there is no such folder
Result<RunBook, QString> readRunBook(
    const QString &folder, const std::function<bool(double)> &proceed = {});

/// Writes a run's note and star anew. @return  empty, or why not
QString annotateRun(const QString &folder, int number, const QString &note, bool starred);

} // namespace session
