// DiskArchive: the archive of a capture on a disk. What is handed over is written in a thread of its own into files
// without a name, so that nothing is left behind however the program ends, and can then be read from there as if it
// were memory. It never writes to a page that is mapped: neither the window nor the link waits for a disk that is slow
// to write. Reading samples that the system has put out of memory waits for the disk: milliseconds. On a disk that
// fails while it is read the archive gives itself up: its budget is 0 until the user sets another, so that the capture
// lets go of what lies there. What was read meanwhile may be zeros.
#pragma once

#include "capture/sample_archive.h"

#include <QObject>
#include <QThread>

#include <functional>

namespace session {

class ArchiveWriter;

/// Why the archive did not take samples.
struct ArchiveFailure {
    enum class Reason : std::uint8_t {
        NoFolder, ///< it cannot be made
        LittleRoom, ///< others need what is left on the disk
        WriteFailed,
        ReadFailed, ///< what was there is lost
    } reason = Reason::WriteFailed;
    QString folder;
    QString systemText; ///< the system's words; may be empty
};

class DiskArchive : public QObject, public capture::SampleArchive {
    Q_OBJECT
public:
    struct Config {
        QString folder; ///< made when it is first needed
        std::uint64_t budget = 0; ///< bytes
        std::uint64_t leaveFree = std::uint64_t{1} << 30; ///< bytes on the disk that are for others
        std::size_t pieceBytes = std::size_t{16}
            << 20; ///< of a file: the system can map some ten thousand
        /// Told of each file that is mapped while it still has its name, in the archive's thread; tests harm it then.
        std::function<void(const QString &path)> mapped = {};
    };
    explicit DiskArchive(Config config);
    /// Waits for what is being written now, not for what waits. What was stored can be read as long as it is held.
    ~DiskArchive() override;

    std::uint64_t budget() const override;
    /// In the thread of the archive. A failure is told again from then on.
    void setBudget(std::uint64_t bytes);
    std::size_t pieceBytes() const override { return m_config.pieceBytes; }
    std::shared_ptr<const capture::Deposit> store(std::vector<capture::Stretch> stretches) override;

    std::uint64_t bytesOnDisk() const; ///< also of what is held by readers only
    QString folder() const { return m_config.folder; }

Q_SIGNALS:
    void failed(const session::ArchiveFailure &failure); ///< the first failure after a setBudget()

private:
    Config m_config;
    std::atomic<std::uint64_t> m_budget;
    mutable std::atomic<bool> m_toldUnreadable = false;
    QThread m_thread;
    std::shared_ptr<ArchiveWriter> m_writer; ///< works in m_thread; what is stored holds it
};

/// A folder for samples on this user's disk.
QString archiveFolder();

/// The lesser of 16 GB and half of what is free on the disk of the folder; 0 if that is no disk but memory.
std::uint64_t usualArchiveBudget(const QString &folder);

} // namespace session

Q_DECLARE_METATYPE(session::ArchiveFailure)
