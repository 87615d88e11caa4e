// SnapshotReader: asks a board for what it holds, some registers at a time, so that polling, commands and the user's
// patience come in between. It reads only. What a build does not have is asked for once a connection.
//
// start(), then progressed() now and then and finished() exactly once, also after cancel().
#pragma once

#include "snapshots/snapshot.h"
#include "widgets/base/device.h"

#include <QObject>
#include <QStringList>

#include <map>
#include <set>

namespace widgets {

struct BoardReading {
    enum class End : std::uint8_t {
        Whole,
        Cancelled,
        Broken, ///< the connection ended, or everything was cancelled by a stop
    };
    End end = End::Whole;
    snapshots::Snapshot snapshot; ///< as far as it came
    QStringList unanswered; ///< registers that may be there and whose answer never came
    QString reason; ///< of Broken: the drive's word
};

class SnapshotReader : public QObject {
    Q_OBJECT
public:
    explicit SnapshotReader(Device &device, QObject *parent = nullptr);

    bool running() const { return m_running; }

public Q_SLOTS:
    void start(snapshots::Scope scope); ///< nothing while one is under way
    void cancel();

Q_SIGNALS:
    void progressed(int done, int total); ///< registers
    void finished(const widgets::BoardReading &reading);

private:
    void ask();
    void accept(const std::vector<drive::Reading> &readings);
    void end(const drive::Ended &ended);
    void finish(BoardReading::End how, const QString &reason = {});

    Device &m_device;
    std::set<catalog::RegisterId> m_absent; ///< of this board
    std::vector<catalog::RegisterId> m_ids; ///< in the snapshot's order
    std::map<catalog::RegisterId, drive::Reading> m_readings;
    std::size_t m_asked = 0;
    drive::WishId m_wish = 0;
    bool m_running = false;
};

} // namespace widgets

Q_DECLARE_METATYPE(widgets::BoardReading)
