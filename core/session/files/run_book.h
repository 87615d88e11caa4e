// A run book: a folder that keeps every experiment as a run, in three files that stand for themselves: "run-0007.pcapng", its
// recording; "run-0007-registers.json", what could be tuned right behind it, a snapshot; and "run-0007.json", what it was and
// what came of it (docs/run-book.md). All of it looks at a disk, so it belongs into a job.
#pragma once

#include "lab/happenings.h"
#include "lab/outcome.h"
#include "session/recording/recording_tap.h"
#include "snapshots/snapshot.h"

#include <QJsonObject>
#include <QMap>
#include <QString>
#include <QStringList>

#include <functional>
#include <utility>
#include <vector>

namespace session {

struct Run {
    int number = 0; ///< from 1
    qint64 at = 0; ///< UTC since 1970, seconds: when it ended
    QString board; ///< its firmware
    QString motorName;
    int motor = 1;
    QString experiment; ///< as a recording names its plan, e.g. "step plan"
    QList<std::pair<QString, QString>> plan; ///< its fields as the recording has them
    QString end; ///< "complete", "refused", "aborted", "interrupted", "lost"
    QString reason;
    QMap<QString, double> gains; ///< registers of the motor, digits
    bool registers = false; ///< they are in a file
    QJsonObject result; ///< as `rotorscope-cli evaluate --json` has it; empty: none
    QStringList notes; ///< what has to be known of the result; the first says why there is none
    QString note; ///< the user's
    bool starred = false;
    bool operator==(const Run &) const = default;
};

QString recordingOf(const QString &folder, int number);
QString registersOf(const QString &folder, int number);

/// What is to be kept of an experiment that has ended.
struct EndedRun {
    record::Begin begin;
    std::vector<ToldPtr> told; ///< between the plan and the end
    std::pair<record::Nanos, record::Happening> plan, end;
    lab::Outcome outcome;
    QString board, motorName;
    int motor = 1;
    qint64 at = 0;
    std::optional<snapshots::Snapshot> registers; ///< empty: they could not be read
};

/// Writes its files and evaluates its recording; it gets the next number. Or says why not, and then nothing of it stays.
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
