#include "session/files/whole_file.h"

#include "session/files/piece_file.h"

#include <QFile>

#include <utility>

namespace session {

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
