#include "session/recording/file.h"

#include "session/files/disk_sync.h"
#include "session/files/whole_file.h"

#include <QFile>
#include <QFileInfo>
#include <QStorageInfo>

#include <cerrno>
#include <filesystem>

namespace session {

namespace {

bool meansFull(int error)
{
#ifdef EDQUOT
    if (error == EDQUOT)
        return true;
#endif
    return error == ENOSPC || error == EFBIG;
}

class DiskSink : public BlockSink {
public:
    explicit DiskSink(const QString &path)
        : m_file(path)
        , m_disk(QFileInfo(QStorageInfo(QFileInfo(path).absolutePath()).rootPath())
                     .filesystemFilePath())
    {
    }

    bool open(QString &systemText)
    {
        if (m_file.open(QIODevice::ReadWrite | QIODevice::NewOnly | QIODevice::Unbuffered)) {
            m_lock = recordingLock(m_file.fileName());
            (void)m_lock->tryLock(); // one that is there is of a file of this name that is no more
            return true;
        }
        systemText = m_file.errorString();
        return false;
    }

    bool append(ByteView bytes) override
    {
        if (!m_file.seek(m_size) || !put(bytes)) {
            m_text = m_file.errorString();
            m_file.resize(m_size); // half a block is no use
            return false;
        }
        m_size += static_cast<qint64>(bytes.size());
        return true;
    }

    bool overwrite(std::size_t offset, ByteView bytes) override
    {
        return m_file.seek(static_cast<qint64>(offset)) && put(bytes);
    }

    bool sync() override
    {
        if (syncToDisk(m_file.handle()))
            return true;
        m_full = meansFull(errno);
        m_text = qt_error_string(errno);
        return false;
    }

    qint64 freeBytes() const override
    {
        std::error_code error;
        return static_cast<qint64>(std::filesystem::space(m_disk, error).available);
    }
    bool isFull() const override { return m_full; }
    QString systemText() const override { return m_text; }

private:
    bool put(ByteView bytes)
    {
        errno = 0;
        if (writeAll(m_file, bytes))
            return true;
        m_full = meansFull(errno) || m_file.error() == QFileDevice::ResourceError;
        return false;
    }

    std::unique_ptr<QLockFile> m_lock; ///< outlives the open file
    QFile m_file;
    /// QStorageInfo reads the list of all disks each time it is asked.
    std::filesystem::path m_disk;
    qint64 m_size = 0;
    bool m_full = false;
    QString m_text;
};

} // namespace

std::unique_ptr<BlockSink> makeDiskSink(const QString &path, QString &systemText)
{
    auto sink = std::make_unique<DiskSink>(path);
    if (!sink->open(systemText))
        return nullptr;
    return sink;
}

RecordingFile::RecordingFile(std::unique_ptr<BlockSink> sink, recorded::Begin begin)
    : m_sink(std::move(sink))
    , m_encoder(std::move(begin))
{
}

bool RecordingFile::add(recorded::Nanos at, const recorded::Entry &entry)
{
    if (m_over)
        return false;
    m_last = std::max(m_last, at);
    if (!m_encoder.add(at, entry))
        ++m_leftOut;
    return writeBlocks();
}

bool RecordingFile::flush(recorded::Nanos now)
{
    if (m_over)
        return false;
    m_encoder.flush(now);
    return writeBlocks();
}

bool RecordingFile::flushAll()
{
    if (m_over)
        return false;
    m_encoder.flushAll();
    return writeBlocks();
}

bool RecordingFile::writeBlocks()
{
    for (const recorded::Block &block : m_encoder.takeBlocks()) {
        if (!write(block))
            return false;
    }
    return true;
}

bool RecordingFile::write(const recorded::Block &block)
{
    if (!m_sink->append(block.bytes)) {
        fail();
        return false;
    }
    ++m_counts.blocks;
    m_counts.bytes += block.bytes.size();
    m_counts.samples += block.samples;
    return true;
}

bool RecordingFile::sync()
{
    if (m_over)
        return false;
    if (m_counts.safeBytes == m_counts.bytes)
        return true;
    if (!m_sink->sync()) {
        fail();
        return false;
    }
    m_counts.safeBytes = m_counts.bytes;
    return true;
}

bool RecordingFile::end()
{
    if (m_over)
        return false;
    m_encoder.addOverview(m_last);
    m_encoder.end(m_last, {});
    if (!writeBlocks() || !sync())
        return false;
    m_over = true;
    return true;
}

/// The disk refused a block, which is gone; the ones before it stay.
void RecordingFile::fail()
{
    using Reason = recorded::End::Reason;
    markEnd({m_sink->isFull() ? Reason::DiskFull : Reason::WriteFailed,
        m_sink->systemText().toStdString()});
}

void RecordingFile::endForWantOfRoom()
{
    if (m_over || !flushAll())
        return;
    markEnd({recorded::End::Reason::DiskFull, "hardly any room left", 0, 0});
}

/// As the last block if the disk takes it, else in the place that was kept for it.
void RecordingFile::markEnd(recorded::End end)
{
    m_over = true;
    m_failure = end;
    (void)m_encoder.takeBlocks();
    const auto reserve = m_encoder.endInReserve(m_last, end);
    m_encoder.end(m_last, std::move(end));
    const auto blocks = m_encoder.takeBlocks();
    if (blocks.empty() || !m_sink->append(blocks.back().bytes))
        (void)m_sink->overwrite(reserve.offset, reserve.bytes);
    (void)m_sink->sync();
}

std::unique_ptr<QLockFile> recordingLock(const QString &path)
{
    auto lock =
        std::make_unique<QLockFile>(QFileInfo(path).canonicalFilePath() + QStringLiteral(".lock"));
    lock->setStaleLockTime(0); // however long it takes
    return lock;
}

} // namespace session
