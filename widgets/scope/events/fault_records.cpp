#include "widgets/scope/events/fault_records.h"

#include <algorithm>

namespace widgets {

FaultRecords::FaultRecords(const capture::Capture &capture, QObject *parent)
    : QObject(parent)
    , m_capture(capture)
{
}

const FaultRecord *FaultRecords::find(quint32 id) const
{
    const auto found = std::find_if(
        m_records.begin(), m_records.end(), [id](const FaultRecord &one) { return one.id == id; });
    return found == m_records.end() ? nullptr : &*found;
}

void FaultRecords::faulted(double seconds, int motor, const QString &fault)
{
    for (FaultRecord &record : m_records)
        if (record.samples == nullptr && record.motor == motor) {
            record.faults += QStringLiteral(", ") + fault;
            Q_EMIT changed();
            return;
        }
    if (m_records.size() >= kMost)
        m_records.pop_front();
    m_records.push_back({++m_lastId, motor, fault, seconds, QDateTime::currentDateTime(), nullptr});
    Q_EMIT changed();
}

void FaultRecords::advance(double now)
{
    for (FaultRecord &record : m_records)
        if (record.samples == nullptr && now >= record.seconds + kAfter + kLate)
            accept(record);
}

void FaultRecords::finish()
{
    for (FaultRecord &record : m_records)
        if (record.samples == nullptr)
            accept(record);
}

void FaultRecords::accept(FaultRecord &record)
{
    record.samples = std::make_shared<capture::Capture>(capture::excerptOf(m_capture,
        capture::toNanos(record.seconds - kBefore), capture::toNanos(record.seconds + kAfter)));
    Q_EMIT changed();
}

} // namespace widgets
