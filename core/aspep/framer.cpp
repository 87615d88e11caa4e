#include "aspep/framer.h"

#include "base/crc.h"

#include <algorithm>
#include <utility>

namespace aspep {
namespace {

constexpr std::size_t kCrcSize = 2;

Framer::Step stepOf(PacketError error)
{
    switch (error) {
    case PacketError::BadHeaderCrc:
        return Framer::Step::BadHeaderCrc;
    case PacketError::UnknownType:
        return Framer::Step::UnknownType;
    case PacketError::Inconsistent:
        break;
    }
    return Framer::Step::Inconsistent;
}

/// Whether a header of any type can begin with this byte: 5, 6, 9, A or F in its lower half.
bool mayBeginHeader(std::uint8_t byte) { return (0x8660U >> (byte & 0xFU) & 1U) != 0; }

/// Firmware that was forced to promise a payload CRC sends the constant CA FE in its place.
bool crcFits(ByteView payload, std::uint8_t low, std::uint8_t high)
{
    const unsigned sent = low | unsigned{high} << 8;
    return sent == 0xFECA || sent == crc16Xmodem(payload);
}

} // namespace

Framer::Step Framer::next(ByteView &bytes, Packet &packet)
{
    if (!m_inStep) {
        hunt(bytes);
        bytes = {};
    }
    while (m_inStep && m_provedAt < m_proved.size()) {
        ByteView proved = ByteView(m_proved).subspan(m_provedAt);
        const Step step = parse(proved, packet);
        m_provedAt = m_proved.size() - proved.size();
        if (step == Step::NeedBytes)
            break;
        if (!m_inStep) { // what came behind the packets that were proved
            const Bytes rest(proved.begin(), proved.end());
            m_proved.clear();
            m_provedAt = 0;
            hunt(rest);
        }
        return step;
    }
    return m_inStep ? parse(bytes, packet) : Step::NeedBytes;
}

void Framer::hunt(ByteView bytes)
{
    m_discarded += bytes.size();
    if (!m_hunt.proves(bytes, m_limits.response, m_limits.dataCrc ? kCrcSize : 0))
        return scan(bytes);
    m_proved = m_hunt.take();
    m_provedAt = 0;
    m_discarded -= m_proved.size() - m_hunt.reused();
    m_scanSize = m_scanSkip = 0;
    m_inStep = true;
}

Framer::Step Framer::parse(ByteView &bytes, Packet &packet)
{
    if (!m_inPayload) {
        const std::size_t part = std::min(kHeaderSize - m_headerSize, bytes.size());
        std::copy_n(
            bytes.begin(), part, m_headerBytes.begin() + static_cast<std::ptrdiff_t>(m_headerSize));
        m_headerSize += part;
        bytes = bytes.subspan(part);
        if (m_headerSize < kHeaderSize)
            return Step::NeedBytes;
        if (const Step step = startPacket(); step != Step::Packet)
            return step;
        if (!m_inPayload) {
            m_hunt.passed();
            packet.header = m_header;
            packet.payload.clear();
            return Step::Packet;
        }
    }
    return acceptPayload(bytes) ? finishPayload(packet) : Step::NeedBytes;
}

Framer::Step Framer::startPacket()
{
    const auto header = decodeHeader(m_headerBytes);
    if (!header)
        return bad(stepOf(header.error()));
    m_header = *header;
    if (const auto *data = std::get_if<Data>(&m_header)) {
        if (tooLong(*data))
            return bad(Step::TooLong);
        m_crcFollows = m_limits.dataCrc && data->length > 0;
        m_payloadSize = data->length + (m_crcFollows ? kCrcSize : 0);
        m_inPayload = m_payloadSize > 0;
        m_payload.reserve(m_payloadSize);
    }
    m_headerSize = 0;
    return Step::Packet;
}

bool Framer::acceptPayload(ByteView &bytes)
{
    const std::size_t part = std::min(m_payloadSize - m_payload.size(), bytes.size());
    m_payload.insert(
        m_payload.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(part));
    bytes = bytes.subspan(part);
    return m_payload.size() == m_payloadSize;
}

Framer::Step Framer::finishPayload(Packet &packet)
{
    m_inPayload = false;
    if (m_crcFollows) {
        const std::size_t length = m_payloadSize - kCrcSize;
        if (!crcFits(ByteView(m_payload).first(length), m_payload[length], m_payload[length + 1])) {
            m_payload.clear();
            return bad(Step::BadPayloadCrc);
        }
        m_payload.resize(length);
    }
    m_hunt.learn(std::get<Data>(m_header), m_payload);
    packet.header = m_header;
    std::swap(packet.payload, m_payload); // its buffer is the next one's
    m_payload.clear();
    return Step::Packet;
}

Framer::Step Framer::bad(Step what)
{
    m_inStep = false;
    m_headerSize = 0;
    m_discarded += kHeaderSize;
    m_scanSize = m_scanSkip = 0;
    const bool header = what != Step::BadPayloadCrc;
    if (header)
        scan(m_headerBytes);
    m_hunt.begin(header ? ByteView(m_headerBytes) : ByteView());
    return what;
}

bool Framer::tooLong(const Data &data) const
{
    return data.length > (data.response ? m_limits.response : m_limits.async);
}

void Framer::scan(ByteView bytes)
{
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t skipped = std::min(m_scanSkip, bytes.size() - at);
        m_scanSkip -= skipped;
        at += skipped;
        // Most of what is discarded: passed over where it lies.
        while (m_scanSize == 0 && at + kHeaderSize <= bytes.size() && !mayBeginHeader(bytes[at]))
            ++at;
        if (at == bytes.size())
            return;
        m_scanWindow[m_scanSize++] = bytes[at++];
        if (m_scanSize < kHeaderSize)
            continue;
        const auto header = decodeHeader(m_scanWindow);
        const Data *data = header ? std::get_if<Data>(&*header) : nullptr;
        if (header && !(data && tooLong(*data))) {
            m_scanSize = 0;
            if (data && data->length > 0)
                m_scanSkip = data->length + (m_limits.dataCrc ? kCrcSize : 0);
        } else if (at >= kHeaderSize - 1) {
            // All but the first of them are here: go on with the second.
            m_scanSize = 0;
            at -= kHeaderSize - 1;
        } else {
            std::copy(m_scanWindow.begin() + 1, m_scanWindow.end(), m_scanWindow.begin());
            --m_scanSize;
        }
    }
}

void Framer::resynchronise()
{
    if (midPacket())
        m_discarded += m_inPayload ? m_payload.size() + kHeaderSize : m_headerSize;
    m_inStep = true;
    m_inPayload = false;
    m_headerSize = 0;
    m_payload.clear();
    m_hunt.end();
    m_proved.clear();
    m_provedAt = 0;
}

std::size_t Framer::missing() const
{
    if (!midPacket())
        return 0;
    return m_inPayload ? m_payloadSize - m_payload.size() : kHeaderSize - m_headerSize;
}

} // namespace aspep
