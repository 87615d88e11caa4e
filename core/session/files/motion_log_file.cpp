#include "session/files/motion_log_file.h"

#include "base/text.h"

#include <QFileInfo>

#include <algorithm>
#include <charconv>

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

std::string hex(const std::vector<Bytes> &requests, std::size_t all)
{
    std::string text;
    for (const Bytes &request : requests)
        text += (text.empty() ? "" : " | ") + hexOf(request, " ");
    if (all > requests.size())
        text += " | and " + std::to_string(all - requests.size()) + " more";
    return text;
}

/// A cell that a spreadsheet takes as text: quoted where it must be, never a formula.
std::string cell(std::string_view text)
{
    std::string safe;
    if (!text.empty() && std::string_view("=+-@\t").find(text.front()) != std::string_view::npos)
        safe.push_back('\'');
    for (const char c : text)
        safe.push_back(static_cast<unsigned char>(c) < 0x20 ? ' ' : c);
    if (safe.find_first_of(",\"") == std::string::npos)
        return safe;
    std::string quoted = "\"";
    for (const char c : safe) {
        if (c == '"')
            quoted.push_back('"');
        quoted.push_back(c);
    }
    return quoted + '"';
}

std::string millisecondsText(Duration time)
{
    char text[32];
    const double value = std::chrono::duration<double, std::milli>(time).count();
    return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 1).ptr};
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

std::string motionLogHeading()
{
    return "number,time,who,source,motor,command,detail,outcome,reason,took [ms],bytes";
}

std::string motionLogLine(const drive::MotionEntry &entry, std::size_t number,
    std::string_view time, std::string_view who)
{
    std::string line = std::to_string(number);
    const auto add = [&line](std::string_view text) { line += ',' + cell(text); };
    add(time);
    add(who);
    add(wordOf(entry.source));
    add(entry.motor > 0 ? std::to_string(entry.motor) : std::string());
    add(wordOf(entry.act));
    add(entry.detail);
    add(entry.stop ? wordOf(*entry.stop) : wordOf(entry.outcome));
    add(entry.reason);
    add(millisecondsText(entry.ended - entry.asked));
    add(hex(entry.sent, entry.requests));
    return line;
}

QByteArray motionLogText(
    const std::vector<LoggedMotion> &log, const QString &who, std::size_t leftOut)
{
    QByteArray text = QByteArray::fromStdString(motionLogHeading()) + '\n';
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
        text += QByteArray::fromStdString(
                    motionLogLine(one.entry, ++number, time.toStdString(), who.toStdString()))
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
