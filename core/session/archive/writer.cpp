#include "session/archive/writer.h"

#include "session/archive/mapped_pieces.h"
#include "session/files/disk_sync.h"
#include "session/files/whole_file.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QStorageInfo>
#include <QUuid>

#include <cerrno>
#include <numeric>

namespace session {

namespace {

constexpr QLatin1String kEnding(".samples");

/// A file that still has its name after so long is of a program that came to a sudden end.
constexpr qint64 kLeftBehind_s = 86400;

std::size_t sizeOf(const std::vector<capture::Stretch> &stretches)
{
    return std::accumulate(stretches.begin(), stretches.end(), std::size_t(0),
        [](std::size_t sum, const capture::Stretch &stretch) { return sum + stretch.size; });
}

} // namespace

/// A file of its own, so that its room on the disk is free when the piece is let go. It has lost its name already where
/// the system allows that, and is closed: the mapping keeps it.
struct ArchiveWriter::Piece {
    QFile file;
    const std::byte *bytes = nullptr;
    std::size_t size = 0;
    std::shared_ptr<ArchiveShared> archive;

    Piece(const QString &path, std::size_t bytesOfIt, std::shared_ptr<ArchiveShared> of)
        : file(path)
        , size(bytesOfIt)
        , archive(std::move(of))
    {
        archive->bytes.fetch_add(size, std::memory_order_relaxed);
    }
    Piece(const Piece &) = delete;
    Piece &operator=(const Piece &) = delete;
    ~Piece()
    {
        // The file object maps for reading only; it takes the address back as it gave it.
        if (bytes) {
            unguardPiece(bytes);
            file.unmap(reinterpret_cast<uchar *>(const_cast<std::byte *>(bytes)));
        }
        file.remove();
        archive->bytes.fetch_sub(size, std::memory_order_relaxed);
    }
};

ArchiveWriter::ArchiveWriter(const DiskArchive::Config &config)
    : m_config(config)
{
}

void ArchiveWriter::write(capture::Deposit &deposit, const std::vector<capture::Stretch> &stretches)
{
    using State = capture::Deposit::State;
    // Settled once. For TSan, which does not see the lock of Qt's queue, this is also where the bytes were handed over.
    if (deposit.state() != State::Waiting)
        return;
    auto piece = makePiece(stretches);
    if (!piece)
        return deposit.settle(State::Refused);
    const auto bytes = shared(std::move(piece));
    std::size_t offset = 0;
    std::vector<capture::Stretch> stored;
    stored.reserve(stretches.size());
    for (const capture::Stretch &stretch : stretches) {
        stored.push_back({{bytes, bytes.get() + offset}, stretch.size});
        offset += stretch.size;
    }
    deposit.settle(State::Stored, std::move(stored));
}

std::unique_ptr<ArchiveWriter::Piece> ArchiveWriter::makePiece(
    const std::vector<capture::Stretch> &stretches)
{
    using Reason = ArchiveFailure::Reason;
    if (m_stopped.load(std::memory_order_relaxed) || m_shared->unreadable.load())
        return nullptr;
    if (!makeFolder()) {
        fail(Reason::NoFolder, QString());
        return nullptr;
    }
    const std::size_t size = sizeOf(stretches);
    const qint64 free = QStorageInfo(m_config.folder).bytesAvailable();
    if (free >= 0 && static_cast<std::uint64_t>(free) < m_config.leaveFree + size) {
        fail(Reason::LittleRoom, QString());
        return nullptr;
    }
    const QString path =
        QDir(m_config.folder)
            .filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + kEnding);
    auto piece = std::make_unique<Piece>(path, size, m_shared);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::NewOnly | QIODevice::Unbuffered,
            QFile::ReadOwner | QFile::WriteOwner)
        || !fill(file, stretches)) {
        if (!m_stopped.load(std::memory_order_relaxed))
            fail(Reason::WriteFailed, file.errorString());
        return nullptr;
    }
    // Only what the disk has is let go in memory: some tell late that they are full.
    if (!syncToDisk(file.handle())) {
        fail(Reason::WriteFailed, qt_error_string(errno));
        return nullptr;
    }
    file.close();
    if (piece->file.open(QIODevice::ReadOnly))
        piece->bytes =
            reinterpret_cast<const std::byte *>(piece->file.map(0, static_cast<qint64>(size)));
    if (!piece->bytes) {
        fail(Reason::WriteFailed, piece->file.errorString());
        return nullptr;
    }
    guardPiece(piece->bytes, size, m_shared->unreadable);
    if (m_config.mapped)
        m_config.mapped(path);
    piece->file.close();
    QFile::remove(path); // from here on nothing is left behind, however the program ends
    return piece;
}

/// Makes the folder, and removes what a program left there that ended before a file had lost its name.
bool ArchiveWriter::makeFolder()
{
    QDir folder(m_config.folder);
    if (m_folderMade && folder.exists())
        return true;
    if (!QDir().mkpath(m_config.folder))
        return false;
    QFile::setPermissions(m_config.folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    if (!m_folderMade) {
        const QDateTime old = QDateTime::currentDateTime().addSecs(-kLeftBehind_s);
        for (const QFileInfo &file :
            folder.entryInfoList({QLatin1Char('*') + kEnding}, QDir::Files))
            if (file.lastModified() < old)
                folder.remove(file.fileName());
    }
    m_folderMade = true;
    return true;
}

bool ArchiveWriter::fill(QFile &file, const std::vector<capture::Stretch> &stretches)
{
    for (const capture::Stretch &stretch : stretches) {
        if (m_stopped.load(std::memory_order_relaxed))
            return false;
        if (!writeAll(
                file, {reinterpret_cast<const std::uint8_t *>(stretch.data.get()), stretch.size}))
            return false;
    }
    return true;
}

/// Letting the last of it go, in any thread, waits neither for the system to unmap it nor for the disk.
std::shared_ptr<const std::byte> ArchiveWriter::shared(std::unique_ptr<Piece> piece)
{
    const std::byte *bytes = piece->bytes;
    return {bytes, [self = shared_from_this(), owned = piece.release()](const std::byte *) {
                // If no work goes on there any more it goes with the writer.
                QMetaObject::invokeMethod(
                    self.get(), [last = std::shared_ptr<Piece>(owned)] {}, Qt::QueuedConnection);
            }};
}

void ArchiveWriter::tellUnreadable()
{
    m_told = false; // it is another matter than what may have been told
    fail(ArchiveFailure::Reason::ReadFailed, QString());
}

void ArchiveWriter::fail(ArchiveFailure::Reason reason, const QString &systemText)
{
    if (std::exchange(m_told, true))
        return;
    Q_EMIT failed({reason, m_config.folder, systemText});
}

} // namespace session
