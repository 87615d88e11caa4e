// ArchiveWriter: writes the files of a DiskArchive, in its thread. Private to DiskArchive.
#pragma once

#include "session/archive/disk_archive.h"

class QFile;

namespace session {

/// What pieces and readers of an archive know of each other, as long as there is one of them.
struct ArchiveShared {
    std::atomic<std::uint64_t> bytes{0}; ///< on the disk
    std::atomic<bool> unreadable{false}; ///< some of them could not be read back
};

class ArchiveWriter : public QObject, public std::enable_shared_from_this<ArchiveWriter> {
    Q_OBJECT
public:
    explicit ArchiveWriter(const DiskArchive::Config &config);

    /// Settles the deposit, whatever happens.
    void write(capture::Deposit &deposit, const std::vector<capture::Stretch> &stretches);
    void tellAgain() { m_told = false; }
    void tellUnreadable();

    // In any thread.
    void stop() { m_stopped.store(true, std::memory_order_relaxed); } ///< refuses from now on
    std::uint64_t bytesOnDisk() const { return m_shared->bytes.load(std::memory_order_relaxed); }
    bool unreadable() const { return m_shared->unreadable.load(std::memory_order_relaxed); }
    void readAgain() { m_shared->unreadable.store(false); }

Q_SIGNALS:
    void failed(const session::ArchiveFailure &failure);

private:
    struct Piece;

    bool makeFolder();
    /// The piece, mapped; nullptr, and told, if it cannot be.
    std::unique_ptr<Piece> makePiece(const std::vector<capture::Stretch> &stretches);
    bool fill(QFile &file, const std::vector<capture::Stretch> &stretches);
    std::shared_ptr<const std::byte> shared(std::unique_ptr<Piece> piece);
    void fail(ArchiveFailure::Reason reason, const QString &systemText);

    DiskArchive::Config m_config;
    bool m_folderMade = false;
    bool m_told = false;
    std::atomic<bool> m_stopped{false};
    std::shared_ptr<ArchiveShared> m_shared = std::make_shared<ArchiveShared>();
};

} // namespace session
