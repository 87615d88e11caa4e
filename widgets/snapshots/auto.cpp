#include "widgets/snapshots/auto.h"

#include "widgets/base/device_text.h"

#include <QDir>
#include <QStandardPaths>

namespace widgets {

QString autoSnapshotFolder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
        .filePath(QStringLiteral("snapshots"));
}

AutoSnapshots::AutoSnapshots(Device &device, const QString &folder, QObject *parent)
    : KeepBeforeWriting(parent)
    , m_reader(device)
    , m_folder(folder)
{
    connect(&m_reader, &SnapshotReader::finished, this, &AutoSnapshots::read);
    connect(&m_folder, &session::SnapshotFolder::saved, this, [this](const QString &file) {
        const QDateTime at = m_saving.front();
        m_saving.pop_front();
        for (Kept &kept : m_kept)
            if (kept.at == at)
                kept.file = file;
    });
    connect(&m_folder, &session::SnapshotFolder::failed, this,
        [this](const QString &file, const QString &why) {
            m_saving.pop_front();
            Q_EMIT told(tr("What the board held before is kept in memory only: %1 was not written "
                           "(%2). Save a snapshot to another place before you leave.",
                "file, the system's words")
                            .arg(deviceText(file), deviceText(why)));
        });
}

void AutoSnapshots::make() { m_reader.start(snapshots::Scope::Tunable); }

void AutoSnapshots::read(const BoardReading &reading)
{
    if (reading.end != BoardReading::End::Whole) {
        Q_EMIT broken(reading.reason.isEmpty()
                ? tr("Nothing was written: the board did not tell what it holds first.")
                : tr("Nothing was written: the board did not tell what it holds first (%1).")
                      .arg(reading.reason));
        return;
    }
    const QDateTime now = QDateTime::currentDateTime();
    m_kept.push_front({now, std::make_shared<const snapshots::Snapshot>(reading.snapshot), {}});
    if (m_kept.size() > kMostInMemory)
        m_kept.pop_back();
    m_saving.push_back(now);
    m_folder.save(now, reading.snapshot);
    if (!reading.unanswered.isEmpty())
        Q_EMIT told(tr("The snapshot before the write is without: %1.", "list of registers")
                        .arg(reading.unanswered.join(QStringLiteral(", "))));
    Q_EMIT made();
}

} // namespace widgets
