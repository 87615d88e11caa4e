// The sign that a recording is being written: a lock file beside it, "name.lock". It goes with the recorder, also where a
// crash left it behind: then its process is no longer there. Where none can be made, nothing is known.
#pragma once

#include <QFileInfo>
#include <QLockFile>

#include <memory>

namespace session {

/// @param path  of a recording that is there, by whatever name
inline std::unique_ptr<QLockFile> recordingLock(const QString &path)
{
    auto lock =
        std::make_unique<QLockFile>(QFileInfo(path).canonicalFilePath() + QStringLiteral(".lock"));
    lock->setStaleLockTime(0); // however long it takes
    return lock;
}

} // namespace session
