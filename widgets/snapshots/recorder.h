// SnapshotRecorder: puts into a recording that runs what the board's registers held: all of them when it begins and
// whenever a board has come, and what was read before a list of writes.
#pragma once

#include "session/recording/recording.h"
#include "widgets/snapshots/auto.h"

#include <functional>

namespace widgets {

class SnapshotRecorder : public QObject {
    Q_OBJECT
public:
    /// All outlive it.
    /// @param now  seconds on the session's axis
    SnapshotRecorder(Device &device, session::Recording &recording, const AutoSnapshots &automatic,
        std::function<double()> now, QObject *parent = nullptr);

private:
    void begin();
    void readIfWanted();
    void add(const char *title, const snapshots::Snapshot &snapshot);

    Device &m_device;
    session::Recording &m_recording;
    std::function<double()> m_now;
    SnapshotReader m_reader;
    bool m_wanted = false; ///< not read to the end yet
};

} // namespace widgets
