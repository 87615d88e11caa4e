// Configuration, blocks and packets of the datalog.
#include "simulation/datalog_recorder.h"

#include <algorithm>

namespace simulation {

namespace {

constexpr std::uint8_t kMfAtEnd = 254;
constexpr std::size_t kStampBytes = 4, kTailBytes = 2;

} // namespace

DatalogRecorder::DatalogRecorder(
    int streams, UnknownSignal unknown, FindSource find, AsyncLine &line)
    : m_streams(std::min(static_cast<std::size_t>(std::max(streams, 0)), kMaxSignals))
    , m_unknown(unknown)
    , m_find(std::move(find))
    , m_line(line)
{
}

mcp::Status DatalogRecorder::configure(const StaleBytes &value)
{
    const std::size_t size = value.u16(0);
    if (size == 0) {
        stop();
        return mcp::Status::Ok;
    }
    if (size > m_line.payloadMax())
        return mcp::Status::NoTxAsyncSpace;
    // From here on a refusal leaves the pending fields changed, as in the firmware.
    m_pending.hfRate = value.u8(2);
    m_pending.hfCount = value.u8(3);
    m_pending.mfRate = value.u8(4);
    m_pending.mfCount = value.u8(5);
    const std::size_t count = std::size_t{m_pending.hfCount} + m_pending.mfCount;
    if (count > m_streams) {
        m_pending.hfCount = m_pending.mfCount = 0; // never walked with more than there is room for
        return mcp::Status::BadRawFormat;
    }
    std::size_t block = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const mcp::RegisterId id{value.u16(6 + 2 * i)};
        const bool fast = i < m_pending.hfCount;
        const auto width = static_cast<std::uint8_t>(fast ? 2 : mcp::scalarWidth(id.type()));
        const Source source = m_find(id);
        if (source.get != nullptr || m_unknown == UnknownSignal::ReadsZero)
            m_pending.logged[i].source = source;
        m_pending.logged[i].width = width;
        block += width;
    }
    if (size < block + kStampBytes + kTailBytes)
        return mcp::Status::NoTxAsyncSpace;
    const std::uint8_t mark = value.u8(6 + 2 * count);
    if (mark == 0) {
        stop();
        return mcp::Status::Ok;
    }
    m_pending.trigger = size - block - kTailBytes;
    m_mark = mark;
    return mcp::Status::Ok;
}

void DatalogRecorder::stop()
{
    m_mark = 0;
    flush();
    m_activeMark = 0;
}

void DatalogRecorder::flush()
{
    if (m_packet.empty())
        return;
    m_packet.push_back(m_activeMark);
    m_packet.push_back(0); // async id: datalog
    m_line.send(m_packet);
    m_packet.clear();
}

void DatalogRecorder::tick(std::uint32_t timestamp)
{
    if (m_mark == 0)
        return;
    if (m_hfIndex < m_active.hfRate) {
        ++m_hfIndex;
        return;
    }
    m_hfIndex = 0;
    if (m_packet.empty()) {
        if (!m_line.acquire())
            return; // both buffers wait for the line: this block is lost
        begin(timestamp);
    }
    if (m_packet.size() <= m_active.trigger)
        appendBlock();
    if (m_packet.size() > m_active.trigger) {
        if (m_active.mfRate == kMfAtEnd)
            appendMf();
        flush();
    }
}

void DatalogRecorder::begin(std::uint32_t timestamp)
{
    m_mfIndex = 0;
    if (m_mark != m_activeMark) {
        m_activeMark = m_mark;
        m_active = m_pending;
    }
    for (unsigned shift = 0; shift < 32; shift += 8)
        m_packet.push_back(static_cast<std::uint8_t>(timestamp >> shift));
}

void DatalogRecorder::appendBlock()
{
    for (std::size_t i = 0; i < m_active.hfCount; ++i)
        append(m_active.logged[i]);
    if (m_active.mfRate >= kMfAtEnd)
        return;
    if (m_mfIndex == m_active.mfRate) {
        m_mfIndex = 0;
        appendMf();
    } else {
        ++m_mfIndex;
    }
}

void DatalogRecorder::appendMf()
{
    for (std::size_t i = 0; i < m_active.mfCount; ++i)
        append(m_active.logged[std::size_t{m_active.hfCount} + i]);
}

void DatalogRecorder::append(const Signal &signal)
{
    const Source &source = signal.source;
    std::uint32_t value = source.get != nullptr ? source.get(*source.of) : 0;
    if (source.upperHalf)
        value >>= 16;
    for (unsigned i = 0; i < signal.width; ++i)
        m_packet.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

} // namespace simulation
