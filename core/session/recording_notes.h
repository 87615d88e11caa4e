// Notes for a recording that is closed: the file is written anew, its own blocks byte by byte and the notes behind them.
// Whatever fails, what was there stays as it was.
#pragma once

#include "record/entry.h"

#include <QString>

#include <functional>

namespace session {

/// @param target  may be the source; another file of that name is replaced
/// @param notes  of record::Note::from; one that is there already gets the new text, and noNote() takes it back
/// @param proceed  called with 0..1; false cancels
/// @return  empty, or in the system's or our own words why nothing was written
QString saveNotes(const QString &source, const QString &target,
    const std::vector<record::Note> &notes, const std::function<bool(double)> &proceed = {});

} // namespace session
