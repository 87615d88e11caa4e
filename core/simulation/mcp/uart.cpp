// The two halves of the simulated serial port.
#include "simulation/mcp/uart.h"

#include <algorithm>

namespace simulation {

UartReceiver::UartReceiver(std::uint32_t baud)
    : m_byteTime(wireTime(1, baud))
{
}

void UartReceiver::put(ByteView bytes, TimePoint now)
{
    for (const std::uint8_t value : bytes) {
        if (m_line.size() >= kMaxQueued)
            return;
        const TimePoint begin = std::max(now, m_line.empty() ? m_lastEnd : m_line.back().end);
        m_line.push_back({begin + m_byteTime, value});
    }
}

bool UartReceiver::idleComesFirst() const
{
    return m_idleEnabled && m_sawByte
        && (m_line.empty() || m_line.front().end - m_byteTime >= m_lastEnd + m_byteTime);
}

std::optional<TimePoint> UartReceiver::nextEvent() const
{
    if (idleComesFirst())
        return m_lastEnd + m_byteTime;
    return m_line.empty() ? std::nullopt : std::optional(m_line.front().end);
}

UartReceiver::Happened UartReceiver::step()
{
    if (idleComesFirst()) {
        m_idleEnabled = false;
        m_errorEnabled = true;
        m_sawByte = false;
        m_held.reset();
        return Happened::LineIdle;
    }
    const Byte byte = m_line.front();
    m_line.pop_front();
    m_lastEnd = byte.end;
    m_sawByte = true;
    const bool before = m_complete;
    accept(byte.value);
    return m_complete && !before ? Happened::TransferComplete : Happened::Nothing;
}

void UartReceiver::accept(std::uint8_t value)
{
    if (m_filled < m_target.size()) {
        m_target[m_filled++] = value;
        m_complete = m_filled == m_target.size();
    } else if (!m_held) {
        m_held = value;
    } else if (m_errorEnabled) {
        m_errorEnabled = false;
        m_idleEnabled = true;
    }
}

void UartReceiver::arm(std::span<std::uint8_t> target)
{
    m_target = target;
    m_filled = 0;
    m_complete = false;
    if (m_held)
        accept(*std::exchange(m_held, std::nullopt));
}

void UartReceiver::awaitIdle()
{
    m_idleEnabled = true;
    m_sawByte = false;
}

void UartReceiver::reset()
{
    const Duration byteTime = m_byteTime;
    *this = UartReceiver(1);
    m_byteTime = byteTime;
}

Transmitter::Transmitter(std::uint32_t baud, Liar &liar)
    : m_baud(baud)
    , m_liar(&liar)
{
}

void Transmitter::sendResponse(Bytes packet, TimePoint now)
{
    sendAsIs(m_liar->packet(Liar::Packet::Response, std::move(packet), now), now);
}

void Transmitter::sendAsIs(Bytes bytes, TimePoint now)
{
    if (!bytes.empty())
        m_response = std::move(bytes);
    start(now);
}

void Transmitter::sendControl(const aspep::HeaderBytes &packet, TimePoint now)
{
    Bytes bytes = m_liar->packet(Liar::Packet::Control, Bytes(packet.begin(), packet.end()), now);
    if (!bytes.empty())
        m_control = std::move(bytes);
    start(now);
}

bool Transmitter::acquireAsync()
{
    if (m_asyncBusy >= 2)
        return false;
    ++m_asyncBusy;
    return true;
}

void Transmitter::releaseAsync() { --m_asyncBusy; }

void Transmitter::sendAsync(Bytes packet, TimePoint now)
{
    packet = m_liar->packet(Liar::Packet::Async, std::move(packet), now);
    if (packet.empty())
        releaseAsync();
    else
        m_async.push_back(std::move(packet));
    start(now);
}

void Transmitter::discardWaiting()
{
    m_response.reset();
    m_control.reset();
    m_asyncBusy -= static_cast<int>(m_async.size());
    m_async.clear();
}

void Transmitter::start(TimePoint now)
{
    if (m_kind != Kind::None)
        return;
    if (m_response) {
        begin(Kind::Response, *std::exchange(m_response, std::nullopt), now);
    } else if (m_control) {
        begin(Kind::Control, *std::exchange(m_control, std::nullopt), now);
    } else if (!m_async.empty()) {
        begin(Kind::Async, std::move(m_async.front()), now);
        m_async.pop_front();
    }
}

void Transmitter::begin(Kind kind, Bytes packet, TimePoint now)
{
    m_kind = kind;
    m_packet = std::move(packet);
    m_start = now;
    m_collected = 0;
}

std::optional<TimePoint> Transmitter::nextEvent() const
{
    return m_kind == Kind::None ? std::nullopt : std::optional(endOf(m_packet.size()));
}

void Transmitter::step()
{
    const TimePoint end = endOf(m_packet.size());
    for (std::size_t i = m_collected; i < m_packet.size(); ++i) {
        m_left.push_back(m_packet[i]);
        m_leftTimes.push_back(endOf(i + 1));
    }
    if (m_kind == Kind::Async)
        --m_asyncBusy;
    m_kind = Kind::None;
    m_packet.clear();
    start(end);
}

namespace {

void passLine(std::uint8_t value, TimePoint end, LineFaults &faults, Bytes &out)
{
    if (faults.corruptAfter && (*faults.corruptAfter)-- == 0) {
        value ^= 1U;
        faults.corruptAfter.reset();
    }
    if (end > faults.muteUntil)
        out.push_back(value);
}

} // namespace

void Transmitter::collect(TimePoint now, LineFaults &faults, Bytes &out)
{
    for (std::size_t i = 0; i < m_left.size(); ++i)
        passLine(m_left[i], m_leftTimes[i], faults, out);
    m_left.clear();
    m_leftTimes.clear();
    if (m_kind == Kind::None)
        return;
    while (m_collected < m_packet.size() && endOf(m_collected + 1) <= now) {
        passLine(m_packet[m_collected], endOf(m_collected + 1), faults, out);
        ++m_collected;
    }
}

void Transmitter::reset() { *this = Transmitter(m_baud, *m_liar); }

} // namespace simulation
