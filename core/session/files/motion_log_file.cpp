#include "session/files/motion_log_file.h"

#include <QFileInfo>

namespace session {

LoggedMotion loggedNow(drive::MotionRecord record, const QDateTime &now)
{
    const auto took =
        std::chrono::duration_cast<std::chrono::milliseconds>(record.ended - record.asked);
    return {std::move(record), now.addMSecs(-took.count())};
}

QString motionLogWho(const QString &program)
{
    for (const char *name : {"USER", "LOGNAME", "USERNAME"})
        if (const QString user = qEnvironmentVariable(name); !user.isEmpty())
            return QStringLiteral("%1, %2").arg(user, program);
    return program;
}

QByteArray motionLogText(const std::vector<LoggedMotion> &log, const QString &who)
{
    QByteArray text = QByteArray::fromStdString(drive::motionLogHeading()) + '\n';
    std::size_t number = 0;
    for (const LoggedMotion &one : log) {
        const QString time = one.asked.toUTC().toString(Qt::ISODateWithMs);
        text += QByteArray::fromStdString(drive::motionLogLine(
                    one.record, ++number, time.toStdString(), who.toStdString()))
            + '\n';
    }
    return text;
}

QString motionLogPath(const QString &capturePath)
{
    const QFileInfo file(capturePath);
    const QString stem = file.suffix().compare(QLatin1String("csv"), Qt::CaseInsensitive) == 0
        ? file.completeBaseName()
        : file.fileName();
    return file.path() + QLatin1Char('/') + stem + QStringLiteral(".motion.csv");
}

} // namespace session
