#include "session/files/piece_file.h"

#include <QFileInfo>
#include <QSaveFile>

namespace session {

namespace {

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
    while (next(piece)) {
        if (!writeAll(file, piece))
            return failed(file, result, FileError::CannotWrite);
        result.bytes += static_cast<qint64>(piece.size());
        if (proceed && !proceed())
            return failed(file, result, FileError::Cancelled);
    }
    if (!file.flush() || file.size() != result.bytes)
        return failed(file, result, FileError::CannotWrite);
    if (!file.commit()) {
        result.error = FileError::CannotReplace;
        result.systemText = file.errorString();
    }
    return result;
}

} // namespace session
