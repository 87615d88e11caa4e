// FaultRecords: what was recorded around each fault, kept whatever the trigger does and whatever is cleared afterwards.
// It knows no board: its owner tells it of faults.
#pragma once

#include "capture/capture.h"

#include <QDateTime>
#include <QObject>
#include <QString>

#include <deque>
#include <memory>

namespace widgets {

struct FaultRecord {
    quint32 id = 0; ///< rises
    int motor = 1;
    QString faults; ///< their names, fit to be shown
    /// When the board told it, on the session's axis; it came up to a question before.
    double seconds = 0.0;
    QDateTime when; ///< the same, on the wall
    std::shared_ptr<capture::Capture> samples; ///< nullptr until what follows the fault is there
};

class FaultRecords : public QObject {
    Q_OBJECT
public:
    static constexpr double kBefore = 1.0, kAfter = 0.5; ///< seconds
    /// Samples arrive some time after they were taken.
    static constexpr double kLate = 0.3; ///< seconds
    static constexpr std::size_t kMost = 10; ///< records; then the oldest goes

    /// @param capture  outlives it
    explicit FaultRecords(const capture::Capture &capture, QObject *parent = nullptr);

    const std::deque<FaultRecord> &records() const { return m_records; } ///< oldest first
    const FaultRecord *find(quint32 id) const; ///< nullptr if it has gone

public Q_SLOTS:
    /// One that comes while a record of the same motor still waits belongs to that record.
    void faulted(double seconds, int motor, const QString &fault);
    void advance(double now); ///< time passes, on the session's axis
    void finish(); ///< the samples are about to go: records that wait take what there is

Q_SIGNALS:
    void changed();

private:
    void accept(FaultRecord &record);

    const capture::Capture &m_capture;
    std::deque<FaultRecord> m_records;
    quint32 m_lastId = 0;
};

} // namespace widgets
