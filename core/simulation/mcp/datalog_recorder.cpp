// Configuration, blocks and packets of the datalog.
#include "simulation/mcp/datalog_recorder.h"

#include <algorithm>
#include <utility>

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
    m_pending.asPrinted = false;
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

mcp::Status DatalogRecorder::configureAsPrinted(const StaleBytes &value, int size)
{
    constexpr std::size_t kFields = 5, kMfWidth = 4;
    Configuration wanted{true, value.u8(0), value.u8(1), value.u8(2), value.u8(3)};
    const std::size_t count = std::size_t{wanted.hfCount} + wanted.mfCount;
    if (size < 0 || static_cast<std::size_t>(size) != kFields + 2 * count)
        return mcp::Status::BadRawFormat;
    if (count > m_streams)
        return mcp::Status::NoTxAsyncSpace;
    std::size_t block = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Source source = m_find(mcp::RegisterId{value.u16(4 + 2 * i)});
        if (source.get == nullptr)
            return mcp::Status::UnknownRegister;
        const auto width = static_cast<std::uint8_t>(i < wanted.hfCount ? 2 : kMfWidth);
        wanted.logged[i] = {source, width};
        block += width;
    }
    const std::uint8_t mark = value.u8(4 + 2 * count);
    if (mark == 0 || count == 0) {
        stop();
        return mcp::Status::Ok;
    }
    if (m_line.payloadMax() < block + kStampBytes + kTailBytes)
        return mcp::Status::NoTxAsyncSpace;
    wanted.trigger = m_line.payloadMax() - block - kTailBytes;
    m_pending = wanted;
    m_mark = mark;
    m_changed = true;
    return mcp::Status::Ok;
}

void DatalogRecorder::reset()
{
    m_mark = m_activeMark = 0;
    m_changed = false;
    if (m_packet.empty())
        return;
    m_packet.clear();
    m_line.release();
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
    constexpr std::uint8_t kDatalog = 0; // the async id
    m_packet.push_back(m_active.asPrinted ? kDatalog : m_activeMark);
    m_packet.push_back(m_active.asPrinted ? m_activeMark : kDatalog);
    m_line.send(m_packet);
    m_packet.clear();
}

void DatalogRecorder::tick(std::uint32_t timestamp)
{
    if (m_mark == 0)
        return;
    if (m_packet.empty() ? m_pending.asPrinted : m_active.asPrinted)
        return tickAsPrinted(timestamp);
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

void DatalogRecorder::tickAsPrinted(std::uint32_t timestamp)
{
    if (m_packet.empty() && std::exchange(m_changed, false)) {
        m_active = m_pending;
        m_activeMark = m_mark;
        m_hfIndex = m_mfIndex = 0;
    }
    const auto due = [](std::uint8_t &counter, std::uint8_t rate) {
        const bool now = counter >= rate;
        counter = now ? 0 : static_cast<std::uint8_t>(counter + 1);
        return now;
    };
    const bool fast = due(m_hfIndex, m_active.hfRate);
    const bool slow = m_active.mfRate < kMfAtEnd && due(m_mfIndex, m_active.mfRate);
    if (!fast && !slow)
        return;
    if (m_packet.empty()) {
        if (!m_line.acquire())
            return;
        appendNumber(timestamp, kStampBytes);
    }
    if (fast)
        appendHf();
    if (slow)
        appendMf();
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
    appendNumber(timestamp, kStampBytes);
}

void DatalogRecorder::appendHf()
{
    for (std::size_t i = 0; i < m_active.hfCount; ++i)
        append(m_active.logged[i]);
}

void DatalogRecorder::appendBlock()
{
    appendHf();
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
    appendNumber(value, signal.width);
}

void DatalogRecorder::appendNumber(std::uint32_t value, std::size_t width)
{
    for (std::size_t i = 0; i < width; ++i)
        m_packet.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

} // namespace simulation
