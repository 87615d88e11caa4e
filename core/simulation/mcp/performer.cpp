// The Performer's receive states and its answers to each kind of packet.
#include "simulation/mcp/performer.h"

#include "base/crc.h"
#include "simulation/simulated_board.h"

#include <algorithm>

namespace simulation {

namespace {

constexpr std::uint32_t kBeacon = 5, kPing = 6, kData = 9;
constexpr std::uint8_t kBadType = 1, kBadSize = 2, kBadHeaderCrc = 4;
constexpr std::size_t kTrailer = 2; ///< where a payload CRC would be

std::uint8_t units(std::size_t bytes, std::size_t unit, std::size_t offset, std::size_t most)
{
    const std::size_t count = std::max(bytes / unit, offset) - offset;
    return static_cast<std::uint8_t>(std::min(count, most));
}

} // namespace

Performer::Performer(const Traits &traits, const BoardOptions &options, UartReceiver &receiver,
    Transmitter &transmitter)
    : m_traits(traits)
    , m_nullCheck(options.nullCheck || traits.asPrinted)
    , m_linkId(static_cast<std::uint8_t>(options.linkId))
    , m_receiver(receiver)
    , m_transmitter(transmitter)
    , m_buffer(options.rxMax + kTrailer)
{
    m_own.version = static_cast<std::uint8_t>(options.version);
    m_own.dataCrc = options.dataCrc;
    m_own.rxUnits = units(options.rxMax, 32, 1, 63);
    m_own.txSyncUnits = units(options.txSyncMax, 32, 1, 127);
    m_own.txAsyncUnits = units(options.txAsyncMax, 64, 0, 127);
    m_reset = m_own;
    armHeader();
}

void Performer::armHeader()
{
    m_receiving = Receiving::Header;
    m_receiver.arm(m_header);
}

void Performer::poll()
{
    if (m_receiving == Receiving::Ready || !m_receiver.takeComplete())
        return;
    if (m_receiving == Receiving::Header)
        decode();
    else
        ready(0);
}

void Performer::ready(std::uint8_t nack)
{
    m_nack = nack;
    m_receiving = Receiving::Ready;
}

void Performer::decode()
{
    m_word = ByteReader(m_header).u32();
    m_length = 0;
    const std::uint32_t type = m_word & 0xFU;
    if (crc4(m_word & 0x0FFFFFFFU) != m_word >> 28) {
        ready(kBadHeaderCrc);
    } else if (type == kBeacon || type == kPing) {
        ready(0);
    } else if (type != kData) {
        ready(kBadType);
    } else {
        // A 16-bit access: bit 16 does not count.
        m_length = static_cast<std::uint16_t>((m_word >> 4) & 0xFFFU);
        if (m_length > m_requestMax) {
            ready(kBadSize);
        } else if (m_length == 0) {
            ready(0);
        } else {
            m_receiving = Receiving::Payload;
            m_receiver.arm(std::span(m_buffer).first(m_length + (m_own.dataCrc ? kTrailer : 0U)));
        }
    }
}

void Performer::handleLineIdle()
{
    if (m_receiving == Receiving::Ready)
        m_receiver.arm(m_header); // task() still acts on what is ready and arms once more
    else
        armHeader();
}

void Performer::task(TimePoint now, const Execute &execute)
{
    if (m_receiving != Receiving::Ready)
        return;
    if (m_nack == 0) {
        act(now, execute);
        armHeader();
        return;
    }
    m_transmitter.sendControl(aspep::encodeHeader(aspep::Nack{m_nack}), now);
    if (m_traits.asPrinted) {
        armHeader();
    } else {
        m_receiving = Receiving::Header;
        m_receiver.awaitIdle();
    }
}

void Performer::act(TimePoint now, const Execute &execute)
{
    switch (m_word & 0xFU) {
    case kBeacon:
        return beacon(now);
    case kPing:
        return ping(now);
    default:
        return request(now, execute);
    }
}

void Performer::beacon(TimePoint now)
{
    const auto field = [this](int shift, std::uint32_t mask) {
        return static_cast<std::uint8_t>((m_word >> shift) & mask);
    };
    const aspep::Beacon theirs{.version = field(4, 7),
        .dataCrc = field(7, 1) != 0,
        .rxUnits = field(8, 0x3F),
        .txSyncUnits = field(14, 0x7F),
        .txAsyncUnits = field(21, 0x7F)};
    if (m_traits.asPrinted)
        return beaconAsPrinted(theirs, now);
    agree(theirs);
    // The firmware lets their rx be smaller than its own; after the minimum that is equality too.
    if (theirs != m_own) {
        m_state = State::Idle;
    } else {
        if (m_state == State::Idle)
            adoptLimits();
        m_state = State::Configured;
    }
    m_transmitter.sendControl(aspep::encodeHeader(m_own), now);
}

/// Every connection starts from what the board can, and what waits from the one before is dropped.
void Performer::beaconAsPrinted(const aspep::Beacon &theirs, TimePoint now)
{
    m_transmitter.discardWaiting();
    m_servicesReset = true;
    m_state = State::Idle;
    m_own = m_reset;
    if (theirs.version == m_reset.version)
        agree(theirs);
    if (theirs == m_own) {
        adoptLimits();
        m_requests = 0;
        m_state = State::Connected;
    }
    m_transmitter.sendControl(aspep::encodeHeader(m_own), now);
}

void Performer::agree(const aspep::Beacon &theirs)
{
    m_own.dataCrc = m_own.dataCrc && theirs.dataCrc;
    m_own.rxUnits = std::min(m_own.rxUnits, theirs.rxUnits);
    m_own.txSyncUnits = std::min(m_own.txSyncUnits, theirs.txSyncUnits);
    m_own.txAsyncUnits = std::min(m_own.txAsyncUnits, theirs.txAsyncUnits);
}

void Performer::adoptLimits()
{
    m_requestMax = std::min(m_own.rxMax(), m_buffer.size() - kTrailer);
    m_responseMax = m_own.txSyncMax();
    m_asyncMax = m_own.txAsyncMax();
}

void Performer::ping(TimePoint now)
{
    aspep::Ping reply{m_state != State::Idle, (m_requests & 1U) != 0, m_linkId,
        static_cast<std::uint16_t>(m_word >> 12)};
    if (m_traits.truncatesPingNumber && m_state == State::Connected)
        reply.number = static_cast<std::uint16_t>((m_word >> 8) & 0xFFU);
    if (m_state == State::Configured)
        m_state = State::Connected;
    m_transmitter.sendControl(aspep::encodeHeader(reply), now);
}

void Performer::request(TimePoint now, const Execute &execute)
{
    if (m_state != State::Connected)
        return;
    ++m_requests;
    if (!m_transmitter.responseFree())
        return; // the one response buffer is still in use: nothing is executed
    if (m_length > 0 || !m_nullCheck) {
        const Bytes payload =
            execute(ByteView(m_buffer).first(m_buffer.size() - kTrailer), m_length, m_responseMax);
        if (payload.empty())
            return;
        m_lastResponse = framed(true, payload);
    }
    if (!m_lastResponse.empty())
        m_transmitter.sendResponse(m_lastResponse, now);
}

Bytes Performer::framed(bool response, ByteView payload) const
{
    const auto header =
        aspep::encodeHeader(aspep::Data{response, static_cast<std::uint16_t>(payload.size())});
    const bool trailer = m_own.dataCrc && !payload.empty();
    Bytes packet(header.size() + payload.size() + (trailer ? kTrailer : 0U));
    const auto behind = std::copy(
        payload.begin(), payload.end(), std::copy(header.begin(), header.end(), packet.begin()));
    if (trailer) { // what every build sends that was forced to agree to a CRC
        behind[0] = 0xCA;
        behind[1] = 0xFE;
    }
    return packet;
}

} // namespace simulation
