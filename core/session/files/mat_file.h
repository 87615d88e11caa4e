// A capture as a MATLAB file (version 5, which MATLAB, Octave and SciPy read), whole or not at all. docs/mat.md
// describes what is in it: a structure for each rate, with the time and a column for each signal, NaN where nothing is
// known.
#pragma once

#include "capture/capture.h"
#include "session/files/whole_file.h"

namespace session {

/// A name that MATLAB takes for a field: letters, digits and _, a letter first, at most 31, told apart from `taken`.
QString matName(const QString &name, const QStringList &taken);

/// Of numbers in a file, 8 each: the format cannot hold much more in one structure, and all of it is in memory at once.
constexpr std::size_t kMostMatBytes = std::size_t{1} << 31;

struct MatResult {
    FileResult file;
    bool tooLong = false; ///< more numbers than kMostMatBytes; nothing was written
    quint64 rows = 0; ///< of all structures
};

/// @param channels  those that are empty are left out
/// @param proceed  told 0..1 while rows are gathered and after each structure; false cancels
/// @param mostBytes  for tests
MatResult writeMatFile(const QString &path, const capture::Snapshot &channels,
    const std::optional<capture::TimeSpan> &range = {},
    const std::function<bool(double)> &proceed = {}, std::size_t mostBytes = kMostMatBytes);

} // namespace session
