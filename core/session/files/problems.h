// What is wrong with a file that is read, what is not in it, and why an export wrote none: once, for the window and the
// command line. English; the window translates its pieces, in the context "FileProblem", those of snapshots in
// "Snapshot".
#pragma once

#include "capture/csv_import.h"
#include "recorded/entry.h"
#include "session/files/export_formats.h"
#include "session/files/problem_words.h"
#include "session/files/rev_up_json.h"
#include "session/files/snapshot_json.h"

namespace session {

/// Where, and what: `line 3, column 2: "x" is no number`.
QString csvProblemText(const capture::CsvError &error, ProblemWords wordsOf = englishWords);
/// A sentence that says what to do; empty if there is no problem.
QString exportProblemText(
    ExportProblem problem, const ExportFormat &format, ProblemWords wordsOf = englishWords);
/// A sentence with the place.
/// @param error  its name fit to be shown
QString snapshotProblemText(
    const QString &file, const SnapshotFileError &error, ProblemWords wordsOf = englishWords);
QString revUpProblemText(
    const QString &file, const RevUpFileError &error, ProblemWords wordsOf = englishWords);
/// What did not get into a recording, e.g. "120 samples, 1 byte of the line"; empty: nothing.
QString lostText(const recorded::Lost &lost, ProblemWords wordsOf = englishWords);

} // namespace session
