// Small files that appear whole or not at all, and that are read with a bound.
#pragma once

#include "base/result.h"

#include <QByteArray>
#include <QString>

namespace session {

constexpr qint64 kMostText = 1 << 20; ///< bytes of a file of parameters, which has a few hundred

/// Replaces the file or leaves what was there. @return  empty, or the system's words for what went wrong
QString writeWholeFile(const QString &path, const QByteArray &content);

/// The content, or the system's words. More than `mostBytes` is an error.
Result<QByteArray, QString> readWholeFile(const QString &path, qint64 mostBytes = 16 << 20);

} // namespace session
