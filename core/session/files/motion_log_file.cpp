#include "session/files/motion_log_file.h"

#include <QFileInfo>

#include <algorithm>

namespace session {

namespace {

constexpr qint64 kJitter_ms = 1000; ///< more than this apart are two clocks, as after a sleep

qint64 milliseconds(TimePoint time)
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
}

/// When it was asked. A record is noted some time after its end, more or less late: the one that was noted soonest tells
/// best how the two clocks go together.
QDateTime askedAt(const std::vector<LoggedMotion> &log, const LoggedMotion &one)
{
    const auto apart = [](const LoggedMotion &each) {
        return each.asked.toMSecsSinceEpoch() - milliseconds(each.record.asked);
    };
    const qint64 own = apart(one);
    qint64 best = own;
    for (const LoggedMotion &other : log)
        if (const qint64 that = apart(other); that < best && own - that < kJitter_ms)
            best = that;
    return one.asked.addMSecs(best - own);
}

} // namespace

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
    std::vector<LoggedMotion> inOrder = log;
    for (LoggedMotion &one : inOrder)
        one.asked = askedAt(log, one);
    std::stable_sort(inOrder.begin(), inOrder.end(),
        [](const LoggedMotion &a, const LoggedMotion &b) { return a.asked < b.asked; });
    std::size_t number = 0;
    for (const LoggedMotion &one : inOrder) {
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
