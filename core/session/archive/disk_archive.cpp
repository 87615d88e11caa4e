#include "session/archive/disk_archive.h"

#include "session/archive/writer.h"

#include <QDir>
#include <QStandardPaths>
#include <QStorageInfo>

namespace session {

DiskArchive::DiskArchive(Config config)
    : m_config(std::move(config))
    , m_budget(m_config.budget)
    , m_writer(std::make_shared<ArchiveWriter>(m_config))
{
    qRegisterMetaType<ArchiveFailure>("session::ArchiveFailure");
    connect(m_writer.get(), &ArchiveWriter::failed, this, &DiskArchive::failed);
    m_thread.setObjectName(QStringLiteral("archive"));
    m_writer->moveToThread(&m_thread);
    m_thread.start(QThread::LowPriority);
}

DiskArchive::~DiskArchive()
{
    m_writer->stop();
    m_thread.quit();
    m_thread.wait();
}

std::uint64_t DiskArchive::budget() const
{
    if (!m_writer->unreadable())
        return m_budget.load(std::memory_order_relaxed);
    if (!m_toldUnreadable.exchange(true))
        QMetaObject::invokeMethod(
            m_writer.get(), [writer = m_writer.get()] { writer->tellUnreadable(); },
            Qt::QueuedConnection);
    return 0;
}

void DiskArchive::setBudget(std::uint64_t bytes)
{
    m_writer->readAgain();
    m_toldUnreadable.store(false);
    m_budget.store(bytes, std::memory_order_relaxed);
    QMetaObject::invokeMethod(
        m_writer.get(), [writer = m_writer.get()] { writer->tellAgain(); }, Qt::QueuedConnection);
}

std::shared_ptr<const capture::Deposit> DiskArchive::store(std::vector<capture::Stretch> stretches)
{
    auto deposit = std::make_shared<capture::Deposit>();
    QMetaObject::invokeMethod(
        m_writer.get(),
        [writer = m_writer.get(), deposit, stretches = std::move(stretches)] {
            writer->write(*deposit, stretches);
        },
        Qt::QueuedConnection);
    return deposit;
}

std::uint64_t DiskArchive::bytesOnDisk() const { return m_writer->bytesOnDisk(); }

QString archiveFolder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation))
        .filePath(QStringLiteral("samples"));
}

std::uint64_t usualArchiveBudget(const QString &folder)
{
    QString existing = QDir(folder).absolutePath();
    while (!QFileInfo::exists(existing) && existing != QFileInfo(existing).path())
        existing = QFileInfo(existing).path();
    const QStorageInfo disk(existing);
    constexpr std::uint64_t kMost = 16'000'000'000;
    if (disk.bytesAvailable() <= 0 || disk.fileSystemType() == "tmpfs")
        return 0;
    return std::min(kMost, static_cast<std::uint64_t>(disk.bytesAvailable()) / 2);
}

} // namespace session
