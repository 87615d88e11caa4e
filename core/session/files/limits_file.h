// The user's own limits, in a file of their own: nothing that happens to other settings takes them away. The window
// writes it, and the command line reads it, too. It appears whole or not at all; what cannot be read is an error, never
// "no limit".
#pragma once

#include "base/result.h"
#include "drive/wish.h"

#include <QString>

#include <optional>

namespace session {

QString limitsPath(); ///< in the user's configuration folder

/// The limits; nothing if there is no such file. @return  else why it cannot be read, in the system's words or ours
Result<std::optional<drive::UserLimits>, QString> loadLimits(const QString &path);

/// Replaces the file, and reads it again. @return  empty, or what went wrong
QString saveLimits(const drive::UserLimits &limits, const QString &path);

} // namespace session
