// Snapshots in words: values of their registers in both unit systems, what is wrong with a file, why something is not
// restored, and the names that files get.
#pragma once

#include "session/files/snapshot_json.h"
#include "snapshots/restore.h"

#include <QDateTime>
#include <QString>

namespace widgets {

/// In the unit people read, without it; names where numbers have them; a dash where `entry` is nullptr.
QString snapshotValueText(const snapshots::Entry *entry);
/// As on the wire.
QString snapshotRawText(const snapshots::Entry *entry);

/// Why a file is no snapshot, and where: one sentence.
QString snapshotFileErrorText(const QString &file, session::SnapshotFileError error);
QString notRestoredText(snapshots::NotRestored why);

/// "2026-05-04_13-02-59_motor_" and `what`, e.g. "snapshot.json".
QString suggestedFileName(const QDateTime &now, const QString &what);

} // namespace widgets
