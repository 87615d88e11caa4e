// AutoSnapshots: before a list of registers is written, everything that can be tuned is read and kept: in memory at
// once, as a file as soon as the disk takes it. A disk that does not is told about and stops no write.
#pragma once

#include "session/files/snapshot_folder.h"
#include "widgets/registers/edits.h"
#include "widgets/snapshots/reader.h"

#include <deque>
#include <memory>

namespace widgets {

/// In the user's data folder.
QString autoSnapshotFolder();

class AutoSnapshots : public KeepBeforeWriting {
    Q_OBJECT
public:
    static constexpr std::size_t kMostInMemory = 20;

    struct Kept {
        QDateTime at;
        std::shared_ptr<const snapshots::Snapshot> snapshot;
        QString file; ///< empty until it is there
    };

    AutoSnapshots(Device &device, const QString &folder, QObject *parent = nullptr);

    /// Of this run of the program, newest first.
    const std::deque<Kept> &kept() const { return m_kept; }
    const session::SnapshotFolder &folder() const { return m_folder; }
    bool running() const { return m_reader.running(); }

    void make() override;

private:
    void read(const BoardReading &reading);

    SnapshotReader m_reader;
    session::SnapshotFolder m_folder;
    std::deque<Kept> m_kept;
    std::deque<QDateTime> m_saving; ///< in the order in which the folder will tell
};

} // namespace widgets
