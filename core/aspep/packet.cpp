#include "aspep/packet.h"

#include "base/crc.h"

namespace aspep {
namespace {

enum Type : std::uint32_t { kBeacon = 5, kPing = 6, kData = 9, kResponse = 10, kNack = 15 };

/// Puts the low `width` bits of `value` at bit `at`.
constexpr std::uint32_t put(std::uint32_t value, int at, int width)
{
    return (value & ((1U << width) - 1)) << at;
}

constexpr std::uint32_t get(std::uint32_t word, int at, int width)
{
    return (word >> at) & ((1U << width) - 1);
}

std::uint32_t bitsOf(const Beacon &b)
{
    return kBeacon | put(b.version, 4, 3) | put(b.dataCrc, 7, 1) | put(b.rxUnits, 8, 6)
        | put(b.txSyncUnits, 14, 7) | put(b.txAsyncUnits, 21, 7);
}

std::uint32_t bitsOf(const Ping &p)
{
    return kPing | put(p.configured ? 3 : 0, 4, 2) | put(p.parity ? 3 : 0, 6, 2)
        | put(p.linkId, 8, 4) | put(p.number, 12, 16);
}

std::uint32_t bitsOf(const Nack &n) { return kNack | put(n.code, 8, 8) | put(n.code, 16, 8); }

std::uint32_t bitsOf(const Data &d)
{
    return (d.response ? kResponse : kData) | put(d.length, 4, 13);
}

Result<Header, PacketError> beaconFrom(std::uint32_t word)
{
    return Beacon{static_cast<std::uint8_t>(get(word, 4, 3)), get(word, 7, 1) != 0,
        static_cast<std::uint8_t>(get(word, 8, 6)), static_cast<std::uint8_t>(get(word, 14, 7)),
        static_cast<std::uint8_t>(get(word, 21, 7))};
}

Result<Header, PacketError> pingFrom(std::uint32_t word)
{
    if (get(word, 4, 1) != get(word, 5, 1) || get(word, 6, 1) != get(word, 7, 1))
        return fail(PacketError::Inconsistent);
    return Ping{get(word, 4, 1) != 0, get(word, 6, 1) != 0,
        static_cast<std::uint8_t>(get(word, 8, 4)), static_cast<std::uint16_t>(get(word, 12, 16))};
}

Result<Header, PacketError> nackFrom(std::uint32_t word)
{
    if (get(word, 8, 8) != get(word, 16, 8) || get(word, 4, 4) != 0 || get(word, 24, 4) != 0)
        return fail(PacketError::Inconsistent);
    return Nack{static_cast<std::uint8_t>(get(word, 8, 8))};
}

Result<Header, PacketError> dataFrom(std::uint32_t word)
{
    if (get(word, 17, 11) != 0)
        return fail(PacketError::Inconsistent);
    return Data{get(word, 0, 4) == kResponse, static_cast<std::uint16_t>(get(word, 4, 13))};
}

} // namespace

HeaderBytes encodeHeader(const Header &header)
{
    const std::uint32_t bits = std::visit([](const auto &h) { return bitsOf(h); }, header);
    const std::uint32_t word = bits | std::uint32_t{crc4(bits)} << 28;
    return {static_cast<std::uint8_t>(word), static_cast<std::uint8_t>(word >> 8),
        static_cast<std::uint8_t>(word >> 16), static_cast<std::uint8_t>(word >> 24)};
}

Result<Header, PacketError> decodeHeader(HeaderBytes bytes)
{
    const std::uint32_t word = bytes[0] | std::uint32_t{bytes[1]} << 8
        | std::uint32_t{bytes[2]} << 16 | std::uint32_t{bytes[3]} << 24;
    if (crc4(word & 0x0FFFFFFFU) != word >> 28)
        return fail(PacketError::BadHeaderCrc);
    switch (get(word, 0, 4)) {
    case kBeacon:
        return beaconFrom(word);
    case kPing:
        return pingFrom(word);
    case kNack:
        return nackFrom(word);
    case kData:
    case kResponse:
        return dataFrom(word);
    default:
        return fail(PacketError::UnknownType);
    }
}

} // namespace aspep
