#include "session/files/whole_file.h"

#include <QFileInfo>
#include <QSaveFile>

namespace session {

QString writeWholeFile(const QString &path, const QByteArray &content)
{
    const QFileInfo existing(path);
    if (existing.exists() && !existing.isFile()) // QSaveFile would take the place of a device
        return QStringLiteral("it is no file");
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
        return file.errorString();
    const auto withReason = [&file] {
        const QString reason = file.errorString();
        file.cancelWriting();
        return reason;
    };
    // A short write is no success: commit() would put a truncated file in place (Qt 6.4).
    for (qint64 at = 0; at < content.size();) {
        const qint64 count = file.write(content.constData() + at, content.size() - at);
        if (count <= 0)
            return withReason();
        at += count;
    }
    if (!file.flush() || file.size() != content.size())
        return withReason();
    return file.commit() ? QString() : file.errorString();
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
