#include "session/files/motion_log_file.h"

#include <QFileInfo>

#include <algorithm>

namespace session {

namespace {

constexpr qint64 kJitter_ms = 1000;

qint64 milliseconds(TimePoint time)
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
}

/// By how much the clock on the wall is ahead of the program's when an entry was noted: with how late it was noted.
qint64 apart(const LoggedMotion &one)
{
    return one.asked.toMSecsSinceEpoch() - milliseconds(one.entry.asked);
}

} // namespace

LoggedMotion loggedNow(drive::MotionEntry entry, const QDateTime &now)
{
    const auto took =
        std::chrono::duration_cast<std::chrono::milliseconds>(entry.ended - entry.asked);
    return {std::move(entry), now.toUTC().addMSecs(-took.count())};
}

bool WallClock::accept(const LoggedMotion &one)
{
    const qint64 own = apart(one);
    const auto at = m_aparts.insert(own);
    return at == m_aparts.upper_bound(own - kJitter_ms);
}

void WallClock::forget(const LoggedMotion &one)
{
    if (const auto at = m_aparts.find(apart(one)); at != m_aparts.end())
        m_aparts.erase(at);
}

QDateTime WallClock::at(const LoggedMotion &one, TimePoint time) const
{
    const qint64 soonest = *m_aparts.upper_bound(apart(one) - kJitter_ms);
    return QDateTime::fromMSecsSinceEpoch(milliseconds(time) + soonest, Qt::UTC);
}

QString motionLogWho(const QString &program)
{
    for (const char *name : {"USER", "LOGNAME", "USERNAME"})
        if (const QString user = qEnvironmentVariable(name); !user.isEmpty())
            return QStringLiteral("%1, %2").arg(user, program);
    return program;
}

QByteArray motionLogText(
    const std::vector<LoggedMotion> &log, const QString &who, std::size_t leftOut)
{
    QByteArray text = QByteArray::fromStdString(drive::motionLogHeading()) + '\n';
    if (leftOut > 0) // in the column of the details
        text += ",,,,,," + QByteArray::number(static_cast<qulonglong>(leftOut))
            + " earlier acts are left out,,,,\n";
    WallClock clock;
    for (const LoggedMotion &one : log)
        clock.accept(one);
    std::vector<LoggedMotion> inOrder = log;
    for (LoggedMotion &one : inOrder)
        one.asked = clock.at(one, one.entry.asked);
    std::ranges::stable_sort(inOrder, {}, &LoggedMotion::asked);
    std::size_t number = leftOut;
    for (const LoggedMotion &one : inOrder) {
        const QString time = one.asked.toString(Qt::ISODateWithMs);
        text += QByteArray::fromStdString(drive::motionLogLine(
                    one.entry, ++number, time.toStdString(), who.toStdString()))
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
