#include "aspep/sender.h"

#include "base/crc.h"

#include <span>

namespace aspep {
namespace {

/// While a packet still waits to be written it cannot be lost: a busy host gets this much more time.
constexpr Duration kUnsentGrace = std::chrono::milliseconds(250);
/// Ends the usual payload that a board still waits for; the longest, 256 bytes, with the third repetition.
constexpr std::size_t kFillBeacons = 20;

} // namespace

std::size_t Sender::send(
    const Packet &packet, bool dataCrc, Duration gap, Duration replyTime, TimePoint now)
{
    const std::size_t before = m_output.size();
    append(m_output, packet, dataCrc, gap);
    std::size_t size = 0;
    m_askedAt = now;
    for (const Output &output : std::span(m_output).subspan(before)) {
        // Nothing answers these bytes that began before they can have begun to leave, behind all that left before them.
        m_answerableAt = std::max(now, m_lineFree + output.gapBefore);
        m_lineFree = m_answerableAt + wireTime(output.bytes.size(), m_baud);
        m_askedAt += output.gapBefore;
        size += output.bytes.size();
    }
    m_askedAt += wireTime(size, m_baud);
    m_replyDue = m_askedAt + replyTime + kUnsentGrace;
    m_sentPending = true;
    return size;
}

void Sender::append(std::vector<Output> &to, const Packet &packet, bool dataCrc, Duration gap) const
{
    const HeaderBytes header = encodeHeader(packet.header);
    to.push_back({Bytes(header.begin(), header.end()), gap});
    if (!std::holds_alternative<Data>(packet.header))
        return;
    Bytes body = packet.payload;
    if (dataCrc) {
        const std::uint16_t crc = crc16Xmodem(packet.payload);
        body.push_back(static_cast<std::uint8_t>(crc));
        body.push_back(static_cast<std::uint8_t>(crc >> 8));
    }
    to.push_back({std::move(body), m_payloadPause});
}

void Sender::handleSent(Duration replyTime, TimePoint now)
{
    if (!m_sentPending || !m_output.empty())
        return;
    m_sentPending = false;
    m_askedAt = now;
    m_answerableAt = std::min(m_answerableAt, now);
    m_lineFree = std::min(m_lineFree, now);
    if (m_replyDue)
        m_replyDue = now + replyTime;
}

bool Sender::justAsked(Duration time, TimePoint now) const
{
    return m_replyDue && m_output.empty() && now - m_askedAt < time;
}

std::vector<Output> Sender::blindScript(
    const std::vector<Bytes> &payloads, const std::optional<Beacon> &known) const
{
    std::vector<Output> script;
    const bool dataCrc = known && known->dataCrc;
    // A board that is connected would leave that state for the offer of a stranger, and not come back without an echo.
    if (known)
        append(script, {*known, {}}, dataCrc, kBlindGap);
    append(script, {Ping{}, {}}, dataCrc, kBlindGap);
    for (const Bytes &payload : payloads)
        append(script, {Data{false, static_cast<std::uint16_t>(payload.size())}, payload}, dataCrc,
            kBlindGap);
    if (known) {
        const HeaderBytes beacon = encodeHeader(*known);
        Output fill{{}, kBlindGap};
        for (std::size_t i = 0; i < kFillBeacons; ++i)
            fill.bytes.insert(fill.bytes.end(), beacon.begin(), beacon.end());
        script.push_back(std::move(fill));
    }
    return script;
}

} // namespace aspep
