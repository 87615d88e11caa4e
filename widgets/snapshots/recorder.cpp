#include "widgets/snapshots/recorder.h"

#include "capture/tick_time.h"
#include "session/files/snapshot_json.h"

namespace widgets {

SnapshotRecorder::SnapshotRecorder(Device &device, session::Recording &recording,
    const AutoSnapshots &automatic, std::function<double()> now, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_recording(recording)
    , m_now(std::move(now))
    , m_reader(device)
{
    connect(&recording, &session::Recording::started, this, &SnapshotRecorder::begin);
    connect(&recording, &session::Recording::finished, this, [this] {
        m_wanted = false;
        m_reader.cancel();
    });
    connect(&device, &Device::identityChanged, this, &SnapshotRecorder::begin);
    // A reading that was broken off is begun anew when the board answers again.
    connect(&device, &Device::linkStateChanged, this, &SnapshotRecorder::readIfWanted);
    connect(&m_reader, &SnapshotReader::finished, this, [this](const BoardReading &reading) {
        if (reading.end != BoardReading::End::Whole)
            return;
        m_wanted = false;
        add("all registers", reading.snapshot);
    });
    connect(&automatic, &AutoSnapshots::made, this,
        [this, &automatic] { add("before a write", *automatic.kept().front().snapshot); });
}

void SnapshotRecorder::begin()
{
    m_wanted = m_recording.running();
    readIfWanted();
}

void SnapshotRecorder::readIfWanted()
{
    if (m_wanted && m_device.answering() && m_device.identified())
        m_reader.start(snapshots::Scope::All);
}

void SnapshotRecorder::add(const char *title, const snapshots::Snapshot &snapshot)
{
    if (!m_recording.running())
        return;
    m_recording.add(capture::toNanos(m_now()),
        recorded::RegisterSnapshot{title, session::snapshotJson(snapshot).toStdString()});
}

} // namespace widgets
