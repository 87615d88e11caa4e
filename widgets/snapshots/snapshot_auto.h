// AutoSnapshots: before a list of registers is written, everything that can be tuned is read and kept: in memory at
// once, as a file as soon as the disk takes it. A disk that does not is told about and stops no write.
#pragma once

#include "session/snapshot_folder.h"
#include "widgets/snapshots/snapshot_reader.h"

#include <deque>
#include <memory>

namespace widgets {

/// In the person's data folder.
QString autoSnapshotFolder();

class AutoSnapshots : public QObject {
    Q_OBJECT
public:
    static constexpr std::size_t kMostInMemory = 20;

    struct Kept {
        QDateTime at;
        std::shared_ptr<const tuning::Snapshot> snapshot;
        QString file; ///< empty until it is there
    };

    AutoSnapshots(Device &device, const QString &folder, QObject *parent = nullptr);

    /// Of this run of the program, newest first.
    const std::deque<Kept> &kept() const { return m_kept; }
    const session::SnapshotFolder &folder() const { return m_folder; }
    bool running() const { return m_reader.running(); }

    void take(); ///< taken() or broken() follows; nothing while one is under way

Q_SIGNALS:
    void taken(); ///< it is in memory: writing may begin
    void broken(const QString &sentence); ///< the board could not be read
    void told(const QString &sentence); ///< something is missing that does not stop a write

private:
    void read(const BoardReading &reading);

    SnapshotReader m_reader;
    session::SnapshotFolder m_folder;
    std::deque<Kept> m_kept;
    std::deque<QDateTime> m_saving; ///< in the order in which the folder will tell
};

} // namespace widgets
