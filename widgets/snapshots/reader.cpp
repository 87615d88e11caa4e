#include "widgets/snapshots/reader.h"

#include "widgets/base/device_text.h"

#include <algorithm>

namespace widgets {
namespace {

// So many that a large board takes few round trips, so few that nothing waits long behind them.
constexpr std::size_t kAtATime = 16;

} // namespace

SnapshotReader::SnapshotReader(Device &device, QObject *parent)
    : QObject(parent)
    , m_device(device)
{
    connect(&device, &Device::readingsArrived, this, &SnapshotReader::accept);
    connect(&device, &Device::wishEnded, this, &SnapshotReader::end);
    connect(&device, &Device::identityChanged, this, [this] {
        m_absent.clear();
        if (m_running)
            finish(BoardReading::End::Broken); // another board, or the same one anew
    });
    connect(&device, &Device::portStateChanged, this, [this] {
        if (m_running && !m_device.portOpen())
            finish(BoardReading::End::Broken);
    });
}

void SnapshotReader::start(snapshots::Scope scope)
{
    if (m_running)
        return;
    m_running = true;
    m_readings.clear();
    m_ids.clear();
    m_asked = 0;
    const auto catalog = m_device.catalog();
    if (!catalog || !m_device.answering())
        return finish(BoardReading::End::Broken);
    for (const catalog::RegisterId id : snapshots::snapshotRegisters(*catalog, scope))
        if (!m_absent.contains(id))
            m_ids.push_back(id);
    ask();
}

void SnapshotReader::cancel()
{
    if (m_running)
        finish(BoardReading::End::Cancelled);
}

void SnapshotReader::ask()
{
    if (m_asked >= m_ids.size())
        return finish(BoardReading::End::Whole);
    const auto from = m_ids.begin() + static_cast<std::ptrdiff_t>(m_asked);
    const std::size_t count = std::min(kAtATime, m_ids.size() - m_asked);
    m_asked += count;
    m_wish =
        m_device.submit(drive::Read{std::vector(from, from + static_cast<std::ptrdiff_t>(count))});
}

void SnapshotReader::accept(const std::vector<drive::Reading> &readings)
{
    if (!m_running)
        return;
    for (const drive::Reading &reading : readings) {
        if (std::find(m_ids.begin(), m_ids.end(), reading.id) == m_ids.end())
            continue;
        if (reading.status != drive::ReadStatus::Ok && reading.at == TimePoint{})
            continue; // no answer
        if (reading.status == drive::ReadStatus::NotSupported)
            m_absent.insert(reading.id);
        m_readings[reading.id] = reading; // what is polled meanwhile is as true
    }
}

void SnapshotReader::end(const drive::Ended &ended)
{
    if (!m_running || ended.id != m_wish)
        return;
    if (ended.outcome == drive::Outcome::NotSent || !m_device.answering())
        return finish(BoardReading::End::Broken, deviceText(ended.reason));
    Q_EMIT progressed(static_cast<int>(m_asked), static_cast<int>(m_ids.size()));
    ask();
}

void SnapshotReader::finish(BoardReading::End how, const QString &reason)
{
    m_running = false;
    m_wish = 0;
    BoardReading result;
    result.end = how;
    result.reason = reason;
    if (const auto catalog = m_device.catalog(); catalog && m_device.identified()) {
        std::vector<drive::Reading> readings;
        readings.reserve(m_ids.size());
        for (const catalog::RegisterId id : m_ids) {
            const auto found = m_readings.find(id);
            if (found != m_readings.end())
                readings.push_back(found->second);
            else if (how == BoardReading::End::Whole)
                result.unanswered.append(deviceText(catalog->nameOf(id)));
        }
        result.snapshot =
            snapshots::snapshotOf(m_device.identified()->identity, *catalog, readings);
    }
    Q_EMIT finished(result);
}

} // namespace widgets
