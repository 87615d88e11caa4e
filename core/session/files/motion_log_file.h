// The motion log as a file: CSV beside a capture, or on its own. Who it was is the user of the system and the program.
#pragma once

#include "drive/motion_entry.h"

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <set>
#include <vector>

namespace session {

/// An entry and when it was asked, by the clock on the wall.
struct LoggedMotion {
    drive::MotionEntry entry;
    QDateTime asked; ///< UTC: a local time costs its zone each time that it is compared
};

/// An entry that came just now: it was asked as much earlier as it took to end.
LoggedMotion loggedNow(drive::MotionEntry entry, const QDateTime &now);

/// The clock on the wall beside the program's own. An entry is noted some time after its end, more or less late: the
/// one that was noted soonest tells best how the two go together. More than a second apart are two settings, as after a
/// sleep.
class WallClock {
public:
    /// @return  whether those before may have another time now: none was noted as soon
    bool accept(const LoggedMotion &one);
    /// Of one that was taken; those that stay may have another time now.
    void forget(const LoggedMotion &one);
    /// @param time  of an entry that was taken: when it was asked, or ended. @return  UTC
    QDateTime at(const LoggedMotion &one, TimePoint time) const;

private:
    std::multiset<qint64> m_aparts;
};

/// "kim, Rotorscope"
QString motionLogWho(const QString &program);

/// One line an entry, without line ends: comma-separated, quoted where needed, a point as decimal sign.
std::string motionLogHeading();
/// @param number  of the entry in its log, from 1
/// @param time    when it was asked, as the caller's clock tells it
/// @param who     the user or program, e.g. "kim, Rotorscope"
std::string motionLogLine(const drive::MotionEntry &entry, std::size_t number,
    std::string_view time, std::string_view who);

/// The whole file, heading included; times are UTC with milliseconds. Costs about 10 us an entry.
/// @param leftOut  acts before the first one that are not held any more: the file says so, and counts them
QByteArray motionLogText(
    const std::vector<LoggedMotion> &log, const QString &who, std::size_t leftOut = 0);

/// The log's name beside a capture: run.csv -> run.motion.csv.
QString motionLogPath(const QString &capturePath);

} // namespace session
