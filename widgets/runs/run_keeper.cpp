#include "widgets/runs/run_keeper.h"

#include "widgets/base/device_text.h"
#include "widgets/files/file_job.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QWidget>

namespace widgets {

RunKeeper::RunKeeper(Device &device, Experiments &experiments, QWidget *window, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_window(window)
    , m_reader(device)
{
    connect(&experiments, &Experiments::ended, this, &RunKeeper::ended);
    // What the registers held behind the last one cannot be read any more.
    connect(&experiments, &Experiments::began, &m_reader, &SnapshotReader::cancel);
    connect(&m_reader, &SnapshotReader::finished, this, [this](const BoardReading &reading) {
        const bool whole = reading.end == BoardReading::End::Whole;
        write(whole ? std::optional(reading.snapshot) : std::nullopt);
    });
}

void RunKeeper::setFolder(const QString &folder)
{
    if (folder == m_folder)
        return;
    m_folder = folder;
    Q_EMIT folderChanged();
}

void RunKeeper::ended(const Experiments::RunPtr &record)
{
    constexpr std::size_t kPlanAndEnd = 2;
    if (m_folder.isEmpty() || record->told.size() <= kPlanAndEnd)
        return; // one of which nothing was recorded never began
    m_reader.cancel();
    auto run = std::make_shared<session::EndedRun>();
    const session::Endpoint &endpoint = m_device.endpoint();
    const bool simulated = endpoint.kind == session::Endpoint::Kind::Simulator;
    run->begin = {record->startSeconds,
        QStringLiteral("Rotorscope %1").arg(QCoreApplication::applicationVersion()).toStdString(),
        simulated ? "simulated board" : endpoint.path.toStdString()};
    run->told = record->told;
    run->plan = record->happenings.front().second;
    run->outcome = record->outcome;
    run->motor = m_device.motor();
    run->at = QDateTime::currentSecsSinceEpoch();
    if (const auto board = m_device.identified()) {
        const drive::Identity &identity = board->identity;
        run->board = QString::fromStdString(identity.firmware);
        const auto motor = static_cast<std::size_t>(run->motor);
        if (motor >= 1 && motor <= identity.motorNames.size())
            run->motorName = QString::fromStdString(identity.motorNames[motor - 1]);
    }
    m_ended = std::move(run);
    m_reader.start(snapshots::Scope::Tunable);
}

void RunKeeper::write(std::optional<snapshots::Snapshot> registers)
{
    if (!m_ended)
        return;
    const auto run = std::exchange(m_ended, nullptr);
    run->registers = std::move(registers);
    new FileJob(
        tr("Keeping a run"),
        [keeper = QPointer(this), run, folder = m_folder](
            const FileJob::Proceed &) -> FileJob::Finish {
            const auto kept = session::keepRun(folder, *run);
            return [keeper, folder, kept] {
                if (!keeper)
                    return;
                if (!kept)
                    Q_EMIT keeper->failed(tr("The run was not kept in %1: %2.", "folder, reason")
                                              .arg(deviceText(folder), deviceText(kept.error())));
                else if (folder == keeper->folder())
                    Q_EMIT keeper->kept(*kept);
            };
        },
        m_window);
}

} // namespace widgets
