#include "widgets/runs/keeper.h"

#include "lab/runner.h"
#include "widgets/base/device_text.h"
#include "widgets/files/job.h"

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
    connect(&m_reader, &SnapshotReader::finished, this, [this](const BoardReading &reading) {
        const bool whole = reading.end == BoardReading::End::Whole;
        write(whole ? std::optional(behindTheRun(reading.snapshot)) : std::nullopt);
    });
    connect(&device, &Device::wishEnded, this, &RunKeeper::noteWrites);
}

RunKeeper::~RunKeeper()
{
    if (m_ended) // no event loop may come any more
        (void)session::keepRun(m_folder, *m_ended);
}

void RunKeeper::setFolder(const QString &folder)
{
    if (folder == m_folder)
        return;
    m_folder = folder;
    Q_EMIT folderChanged();
}

void RunKeeper::ended(const Experiments::RunPtr &run)
{
    constexpr std::size_t kPlanAndEnd = 2;
    if (m_folder.isEmpty() || run->told.size() <= kPlanAndEnd)
        return; // one of which nothing was recorded never began
    m_reader.cancel();
    auto entry = std::make_shared<session::EndedRun>();
    const session::Endpoint &endpoint = m_device.endpoint();
    const bool simulated = endpoint.kind == session::Endpoint::Kind::Simulator;
    entry->begin = {run->startSeconds,
        QStringLiteral("Rotorscope %1").arg(QCoreApplication::applicationVersion()).toStdString(),
        simulated ? "simulated board" : endpoint.path.toStdString()};
    entry->told = run->told;
    entry->plan = run->happenings.front().second;
    entry->outcome = run->outcome;
    // Another may be shown by now.
    entry->motor = entry->plan.number<int>("motor").value_or(m_device.motor());
    entry->at = QDateTime::currentSecsSinceEpoch();
    if (const auto board = m_device.identified()) {
        const drive::Identity &identity = board->identity;
        entry->board = QString::fromStdString(identity.firmware);
        const auto motor = static_cast<std::size_t>(entry->motor);
        if (motor >= 1 && motor <= identity.motorNames.size())
            entry->motorName = QString::fromStdString(identity.motorNames[motor - 1]);
    }
    m_ended = std::move(entry);
    m_before.clear();
    m_reader.start(snapshots::Scope::Tunable);
}

/// What the experiment gave back itself may be told late, and is as it was behind it. Wishes of an experiment have the
/// time in their numbers at which it began: those of the next one come behind this one's end.
void RunKeeper::noteWrites(const drive::Ended &ended)
{
    if (!m_ended)
        return;
    const auto end = m_ended->outcome.at.time_since_epoch().count();
    if (ended.id >= lab::Runner::kFirstWish
        && ended.id - lab::Runner::kFirstWish < static_cast<drive::WishId>(end))
        return;
    for (const drive::WriteResult &one : ended.writes)
        if (one.before)
            m_before.emplace(one.id, *one.before);
}

snapshots::Snapshot RunKeeper::behindTheRun(const snapshots::Snapshot &read) const
{
    const auto catalog = m_device.catalog();
    if (m_before.empty() || !catalog)
        return read;
    std::vector<drive::Reading> readings;
    readings.reserve(read.entries.size());
    for (const snapshots::Entry &entry : read.entries) {
        const auto before = m_before.find(entry.id);
        drive::Reading reading;
        reading.id = entry.id;
        reading.value = before == m_before.end() ? entry.value : before->second;
        readings.push_back(std::move(reading));
    }
    return snapshots::snapshotOf(read.board, *catalog, readings);
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
