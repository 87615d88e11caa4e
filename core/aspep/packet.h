// ASPEP packets and their 4-byte headers. Values in, values out: no buffers kept, no state.
//
// Wire layout, bit 0 first, little-endian; bits 28-31 are always a CRC-4 of bits 0-27:
//   Beacon  0-3 =5 | 4-6 version | 7 data CRC | 8-13 rx | 14-20 tx sync | 21-27 tx async
//   Ping    0-3 =6 | 4, 5 configured (twice) | 6, 7 packet parity (twice) | 8-11 link id | 12-27
//   number Nack    0-3 =F | 4-7 =0 | 8-15 error | 16-23 error again | 24-27 =0 Data    0-3 =9
//   request (to the Performer) or async (from it), =A response | 4-16 payload length | 17-27 =0
// Source: firmware 6.0 to 6.4.2 and captures of a 6.3.2 board; the printed text agrees but for the
// CRC-4 (base/crc.h).
#pragma once

#include "base/bytes.h"
#include "base/result.h"

#include <array>
#include <cstdint>
#include <variant>

namespace aspep {

using HeaderBytes = std::array<std::uint8_t, 4>;
constexpr std::size_t kHeaderSize = 4;
constexpr std::size_t kMaxPayload = 8191; ///< what 13 bits of length can announce

enum class PacketError : std::uint8_t {
    BadHeaderCrc,
    UnknownType,
    Inconsistent, ///< a field sent twice differs, or a field that is always zero is not
};

/// What one side can do, in the units of the wire.
struct Beacon {
    std::uint8_t version = 0;
    bool dataCrc = false;
    std::uint8_t rxUnits = 63; ///< a request holds up to (rxUnits + 1) * 32 bytes
    std::uint8_t txSyncUnits = 127; ///< a response holds up to (txSyncUnits + 1) * 32 bytes
    /// An async packet holds up to txAsyncUnits * 64 bytes; 0: there are none.
    std::uint8_t txAsyncUnits = 127;

    std::size_t rxMax() const { return (std::size_t{rxUnits} + 1) * 32; }
    std::size_t txSyncMax() const { return (std::size_t{txSyncUnits} + 1) * 32; }
    std::size_t txAsyncMax() const { return std::size_t{txAsyncUnits} * 64; }
    bool operator==(const Beacon &) const = default;
};

struct Ping {
    bool configured = false;
    /// Lowest bit of the number of requests accepted since the Performer's reset.
    bool parity = false;
    std::uint8_t linkId = 0;
    std::uint16_t number = 0;
    bool operator==(const Ping &) const = default;
};

/// The Performer's ERROR packet. Codes: 1 bad type, 2 bad size, 4 bad header CRC, 5 bad payload
/// CRC.
struct Nack {
    std::uint8_t code = 0;
    bool operator==(const Nack &) const = default;
};

/// A request, an async packet or a response: a header that announces a payload.
struct Data {
    bool response = false; ///< type 0xA; otherwise type 9, request or async by direction
    std::uint16_t length = 0; ///< payload bytes, without the payload CRC
    bool operator==(const Data &) const = default;
};

using Header = std::variant<Beacon, Ping, Nack, Data>;

/// Four bytes ready for the wire, CRC included. Fields are cut to their width.
HeaderBytes encodeHeader(const Header &header);

/// The header that four bytes hold.
Result<Header, PacketError> decodeHeader(HeaderBytes bytes);

/// One whole packet as it crosses between codec and machines.
struct Packet {
    Header header;
    Bytes payload; ///< for Data: `length` bytes, payload CRC removed
    bool operator==(const Packet &) const = default;
};

} // namespace aspep
