#include "session/files/piece_file.h"

#include "session/archive/disk_room.h"

#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>

namespace session {

namespace {

constexpr qint64 kMostRoom = 16 << 20; ///< bytes asked for at a time

/// A short write is no success: commit() would put a truncated file in place (Qt 6.4). Only writing the rest tells why.
bool writeAll(QSaveFile &file, std::string_view text)
{
    while (!text.empty()) {
        const qint64 count = file.write(text.data(), static_cast<qint64>(text.size()));
        if (count <= 0)
            return false;
        text.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

/// The old file stays.
FileResult failed(QSaveFile &file, FileResult result, FileError error)
{
    result.error = error;
    if (error != FileError::Cancelled)
        result.systemText = file.errorString();
    file.cancelWriting();
    return result;
}

} // namespace

FileResult writePieces(const QString &path, const std::function<bool(std::string_view &)> &next,
    const std::function<bool()> &proceed)
{
    FileResult result;
    // QSaveFile would put a file in the place of a device.
    const QFileInfo existing(path);
    if (existing.exists() && !existing.isFile()) {
        result.error = FileError::NotAFile;
        return result;
    }
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered)) {
        result.error = FileError::CannotOpen;
        result.systemText = file.errorString();
        return result;
    }
    std::string_view piece;
    qint64 reserved = 0;
    while (next(piece)) {
        const auto size = static_cast<qint64>(piece.size());
        if (result.bytes > 0 && result.bytes + size > reserved) { // not for a file of one piece
            // No more than was written so far: others want room, too.
            reserved = result.bytes + std::max(size, std::min(result.bytes, kMostRoom));
            reserveRoom(file.handle(), result.bytes, reserved - result.bytes);
        }
        if (!writeAll(file, piece))
            return failed(file, result, FileError::CannotWrite);
        result.bytes += size;
        if (proceed && !proceed())
            return failed(file, result, FileError::Cancelled);
    }
    if (!file.flush() || file.size() != result.bytes)
        return failed(file, result, FileError::CannotWrite);
    // Gives back what is left of the room; where that is refused, there was none to be had.
    if (reserved > 0)
        file.resize(result.bytes);
    if (!file.commit()) {
        result.error = FileError::CannotReplace;
        result.systemText = file.errorString();
    }
    return result;
}

} // namespace session
