// A file that is made piece by piece and appears whole or not at all: what was there before stays until then.
#pragma once

#include <QString>

#include <functional>
#include <string_view>

namespace session {

enum class FileError : std::uint8_t {
    None,
    Cancelled,
    NotAFile, ///< a device, a pipe or a folder: taking its place would harm it
    CannotOpen, ///< folder missing, read-only, no permission
    CannotWrite, ///< disk full, drive gone; nothing was replaced
    CannotReplace, ///< written, but could not take the file's place
};

struct FileResult {
    FileError error = FileError::None;
    QString systemText; ///< the system's words for it, e.g. "No space left on device"
    qint64 bytes = 0;
};

/// Writes the pieces until there are none.
/// @param next      shows the next piece, which need not live beyond the following call; false when there is none
/// @param proceed   called behind each piece; false cancels
FileResult writePieces(const QString &path, const std::function<bool(std::string_view &)> &next,
    const std::function<bool()> &proceed = {});

} // namespace session
