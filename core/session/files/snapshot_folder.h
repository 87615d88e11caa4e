// A folder of snapshot files that fills by itself and never grows beyond a number of them. Files are written whole or
// not at all, in a thread of its own: a slow or full disk never delays a stop.
#pragma once

#include "snapshots/snapshot.h"

#include <QDateTime>
#include <QObject>
#include <QStringList>
#include <QThread>

namespace session {

class SnapshotWriter;

/// "2026-05-04_13-02-59_motor_before-write.json"
QString keptSnapshotName(const QDateTime &at);

class SnapshotFolder : public QObject {
    Q_OBJECT
public:
    /// Of the folder's own names; the user's files are not touched.
    static constexpr qsizetype kMostFiles = 50;

    explicit SnapshotFolder(const QString &path, QObject *parent = nullptr);
    ~SnapshotFolder() override; ///< waits until what was asked for is written

    const QString &path() const { return m_path; }
    /// The folder's own files as they are now, newest first, whole paths. Looks at the disk.
    QStringList files() const;

    /// saved() or failed() follows, for several in their order. The same as in the newest file is not written again.
    void save(const QDateTime &at, const snapshots::Snapshot &snapshot);

Q_SIGNALS:
    void saved(const QString &file);
    void failed(const QString &file, const QString &systemText);

private:
    QString m_path;
    QThread m_thread;
    SnapshotWriter *m_writer; ///< lives in the thread and goes with it
};

} // namespace session
