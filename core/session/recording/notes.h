// Notes for a recording that is closed: the file is written anew, its own blocks byte by byte and the notes behind
// them. Whatever fails, what was there stays as it was.
#pragma once

#include "recorded/entry.h"

#include <QDateTime>
#include <QString>

#include <functional>

namespace session {

/// What a caller knows of the source. A file without an end may still be written by another program.
struct NotesSource {
    qint64 bytes = -1; ///< when it was opened; negative: not known
    /// Its time after this program itself wrote it in its place; invalid: not yet.
    QDateTime ownTime;
    QDateTime now; ///< invalid: what has no end counts as being written
};

struct NotesResult {
    enum class Outcome : std::uint8_t {
        Saved,
        BeingWritten, ///< what its recorder still writes would be lost: a copy under another name may be made
        Failed,
    };
    Outcome outcome = Outcome::Failed;
    QString why; ///< in the system's or our own words; empty if saved
    NotesSource target; ///< once saved: what to tell of it the next time, besides the time
};

/// A file without an end that was changed later is being written.
constexpr int kQuietBefore_ms = 10'000;

/// @param target  may be the source; another file of that name is replaced
/// @param notes  of recorded::Note::from; one that is there already gets the new text, and noNote() takes it back
/// @param proceed  called with 0..1; false cancels
NotesResult saveNotes(const QString &source, const QString &target,
    const std::vector<recorded::Note> &notes, const std::function<bool(double)> &proceed = {},
    const NotesSource &known = {});

} // namespace session
