#include "session/files/whole_file.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <utility>

namespace session {

namespace {

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

bool writeAll(QFileDevice &file, ByteView bytes)
{
    while (!bytes.empty()) {
        const qint64 count = file.write(
            reinterpret_cast<const char *>(bytes.data()), static_cast<qint64>(bytes.size()));
        if (count <= 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

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
        if (!writeAll(file, {reinterpret_cast<const std::uint8_t *>(piece.data()), piece.size()}))
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

QString writeWholeFile(const QString &path, const QByteArray &content)
{
    bool shown = false;
    const FileResult written = writePieces(path, [&](std::string_view &piece) {
        piece = {content.constData(), static_cast<std::size_t>(content.size())};
        return !std::exchange(shown, true);
    });
    return written.error == FileError::NotAFile ? QStringLiteral("it is no file")
                                                : written.systemText;
}

Result<QByteArray, QString> readWholeFile(const QString &path, qint64 mostBytes)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return fail(file.errorString());
    QByteArray content = file.read(mostBytes + 1);
    if (file.error() != QFileDevice::NoError)
        return fail(file.errorString());
    if (content.size() > mostBytes)
        return fail(QStringLiteral("it is longer than any such file"));
    return content;
}

} // namespace session
