// Snapshots as JSON text, for files that people compare and keep in version control. One register a line, in a
// stable order, no time in it: the same values give the same bytes. docs/snapshot.md describes the form.
#pragma once

#include "base/result.h"
#include "tuning/snapshot.h"

#include <QByteArray>
#include <QString>

namespace session {

QByteArray snapshotJson(const tuning::Snapshot &snapshot);

/// The snapshot in a file's content, or one sentence without a full stop that says what is wrong with it. Members
/// that are not known are passed over; a register that does not make sense is an error.
Result<tuning::Snapshot, QString> readSnapshotJson(const QByteArray &text);

} // namespace session
