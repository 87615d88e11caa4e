// Lies about packets: BEACONs, PINGs, headers, times and marks of the datalog, and what travels along.
#include "simulation/mcp/liars.h"

#include "aspep/packet.h"
#include "base/crc.h"

#include <algorithm>
#include <array>
#include <utility>

namespace simulation {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kHeader = aspep::kHeaderSize;
/// Of a datalog packet; behind the samples are mark and async id.
constexpr std::size_t kStampAt = kHeader;
constexpr std::size_t kLeastAsync = 6;
constexpr std::array<std::uint8_t, 4> kErrors{1, 2, 4, 5};

std::optional<aspep::Header> headerOf(const Bytes &packet)
{
    aspep::HeaderBytes bytes{};
    if (packet.size() < bytes.size())
        return std::nullopt;
    std::copy_n(packet.begin(), bytes.size(), bytes.begin());
    const auto header = aspep::decodeHeader(bytes);
    return header ? std::optional(*header) : std::nullopt;
}

Bytes bytesOf(const aspep::Header &header)
{
    const auto bytes = aspep::encodeHeader(header);
    return {bytes.begin(), bytes.end()};
}

Bytes joined(Bytes first, const Bytes &second)
{
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// The packet with another length in its header; what follows stays.
Bytes announcing(Bytes packet, std::size_t length, bool response)
{
    const Bytes header = bytesOf(
        aspep::Data{response, static_cast<std::uint16_t>(std::min(length, aspep::kMaxPayload))});
    std::copy(header.begin(), header.end(), packet.begin());
    return packet;
}

/// An ERROR whose two codes differ; no encoder makes one.
Bytes contradictoryError()
{
    constexpr std::uint32_t kWord = 0x0005040F;
    return ByteWriter().u32(kWord | std::uint32_t{crc4(kWord)} << 28).take();
}

} // namespace

Bytes Liar::control(Bytes packet)
{
    const auto header = headerOf(packet);
    if (!header)
        return packet;
    if (std::holds_alternative<aspep::Beacon>(*header))
        return beacon(packet);
    if (std::holds_alternative<aspep::Ping>(*header))
        return ping(packet);
    return packet;
}

Bytes Liar::beacon(const Bytes &packet)
{
    auto beacon = std::get<aspep::Beacon>(*headerOf(packet));
    if (happens(Lie::WrongVersion))
        beacon.version = 3;
    if (happens(Lie::CounterProposals)) {
        beacon.rxUnits = static_cast<std::uint8_t>(1 + ++m_offers % 60);
        beacon.txSyncUnits = static_cast<std::uint8_t>(below(128));
    }
    if (happens(Lie::ShrinkingOffers)) {
        ++m_offers;
        const auto less = [this](std::uint8_t units) {
            return static_cast<std::uint8_t>(units >> std::min<unsigned>(m_offers / 2U, 7U));
        };
        beacon.rxUnits = less(beacon.rxUnits);
        beacon.txSyncUnits = less(beacon.txSyncUnits);
        beacon.txAsyncUnits = less(beacon.txAsyncUnits);
    }
    return bytesOf(beacon);
}

Bytes Liar::ping(const Bytes &packet)
{
    auto ping = std::get<aspep::Ping>(*headerOf(packet));
    if (happens(Lie::NeverConfigured))
        ping.configured = false;
    if (happens(Lie::FalseParity))
        ping.parity = !ping.parity;
    if (happens(Lie::OtherNumber))
        ping.number = static_cast<std::uint16_t>(random());
    return bytesOf(ping);
}

Bytes Liar::response(Bytes packet, TimePoint now)
{
    const Bytes honest = packet;
    if (happens(Lie::UnknownErrors))
        packet = below(2) == 0 ? bytesOf(aspep::Nack{0x77}) : contradictoryError();
    if (happens(Lie::EmptyAnswer))
        packet = bytesOf(aspep::Data{true, 0});
    if (happens(Lie::ResetsInAnswer)) {
        packet.resize(packet.size() / 2);
        m_restart = true;
    }
    if (happens(Lie::WrongLength))
        packet = lengthened(std::move(packet));
    if (happens(Lie::Twice))
        packet = joined(packet, honest);
    if (happens(Lie::LateErrors))
        hold(now + 30ms, bytesOf(aspep::Nack{kErrors[below(kErrors.size())]}));
    m_lastResponse = honest;
    if (happens(Lie::LateAnswer)) {
        hold(now + m_replyTime / 2
                + Duration(below(static_cast<std::uint64_t>(m_replyTime.count()) * 3 / 2)),
            std::move(packet));
        return {};
    }
    return packet;
}

/// A header that does not say how much follows.
Bytes Liar::lengthened(Bytes packet)
{
    const std::size_t length = packet.size() - kHeader;
    switch (below(4)) {
    case 0:
        return announcing(std::move(packet), 0, true);
    case 1:
        return announcing(std::move(packet), aspep::kMaxPayload, true);
    case 2:
        return announcing(std::move(packet), length + 1 + below(16), true);
    default:
        return announcing(
            std::move(packet), length - std::min<std::size_t>(length, 1 + below(4)), true);
    }
}

Bytes Liar::async(Bytes packet)
{
    const auto header = headerOf(packet);
    const auto *data = header ? std::get_if<aspep::Data>(&*header) : nullptr;
    if (data == nullptr || data->length < kLeastAsync || packet.size() < kHeader + data->length)
        return packet;
    const std::size_t end = kHeader + data->length;
    lieAboutTime(packet);
    lieAboutMark(packet, end);
    if (happens(Lie::AsyncId))
        packet[end - 1] = static_cast<std::uint8_t>(1 + below(255));
    if (happens(Lie::OddPacket)) {
        const Bytes tail(packet.begin() + static_cast<std::ptrdiff_t>(end - 2), packet.end());
        packet.resize(end - 3);
        packet = announcing(joined(std::move(packet), tail), data->length - 1U, false);
    }
    return packet;
}

void Liar::lieAboutTime(Bytes &packet)
{
    const std::uint32_t honest = ByteReader(ByteView(packet).subspan(kStampAt, 4)).u32();
    if (happens(Lie::TimeForward))
        m_timeShift += static_cast<std::uint32_t>(1U << below(29));
    if (happens(Lie::TimeBack))
        m_timeShift -= static_cast<std::uint32_t>(1U << below(29));
    std::uint32_t stamp = honest + m_timeShift;
    if (happens(Lie::TimeOdd))
        stamp += static_cast<std::uint32_t>(1 + below(7));
    if (happens(Lie::TimeFrozen)) {
        m_frozenTime = m_frozenTime.value_or(honest);
        stamp = *m_frozenTime;
    }
    const Bytes bytes = ByteWriter().u32(stamp).take();
    std::copy(bytes.begin(), bytes.end(), packet.begin() + kStampAt);
}

void Liar::lieAboutMark(Bytes &packet, std::size_t end)
{
    constexpr int kLate = 2;
    std::uint8_t &mark = packet[end - 2];
    if (mark != m_mark) {
        m_formerMark = std::exchange(m_mark, mark);
        m_oldPackets = 0;
    }
    if (m_oldPackets < kLate && m_formerMark != 0 && happens(Lie::OldMark))
        mark = m_formerMark;
    ++m_oldPackets;
    // Not the mark of the configuration before or behind: that lie could not be noticed.
    if (happens(Lie::WrongMark))
        mark = static_cast<std::uint8_t>(mark + 3 + below(250));
    if (happens(Lie::MarkZero))
        mark = 0;
}

Bytes Liar::withCompany(Bytes packet)
{
    if (packet.empty())
        return packet;
    if (happens(Lie::TornPackets))
        packet.resize(1 + below(packet.size()));
    if (happens(Lie::ErrorStorm))
        packet = joined(bytesOf(aspep::Nack{kErrors[below(kErrors.size())]}), packet);
    if (happens(Lie::Noise))
        packet = joined(std::move(packet), noise(1 + below(40)));
    return packet;
}

} // namespace simulation
