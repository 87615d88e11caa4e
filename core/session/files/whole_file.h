// Files that appear whole or not at all: what was there before stays until then. Small ones are made at once and read
// with a bound, others are made piece by piece.
#pragma once

#include "base/bytes.h"
#include "base/result.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <functional>
#include <string_view>

class QFileDevice;

namespace session {

/// A short write is no success: commit() would put a truncated file in place (Qt 6.4), and a disk that fills up takes a
/// part first. Only writing the rest tells why.
bool writeAll(QFileDevice &file, ByteView bytes);

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

constexpr qint64 kMostText = 1 << 20; ///< bytes of a file of parameters, which has a few hundred

/// Replaces the file or leaves what was there. @return  empty, or the system's words for what went wrong
QString writeWholeFile(const QString &path, const QByteArray &content);

/// The content, or the system's words. More than `mostBytes` is an error.
Result<QByteArray, QString> readWholeFile(const QString &path, qint64 mostBytes = 16 << 20);

} // namespace session
