// The frame of a recording: blocks of pcapng, with two checksums each. Values in, bytes out and back; no state.
//
// Every entry is an Enhanced Packet Block, so that any program that reads pcapng finds them:
//   type 6 | total length | interface | time high | time low | captured | original   28 bytes
//   data, padded to 4
//   epb_flags (direction) | epb_packetid | epb_hash (CRC-32 of the data) | end        36 bytes
//   total length
// epb_packetid: bits 0-31 the block's number in its file; bits 32-63 the CRC-32 of the 28 bytes, the direction and the
// number, so that nothing of a block is unchecked. Time is in nanoseconds of the session; the offset to UTC is in the
// interface. Source: draft-ietf-opsawg-pcapng, sections 4.1 to 4.3; docs/recording-format.md.
#pragma once

#include "base/bytes.h"
#include "capture/tick_time.h"

#include <optional>
#include <string_view>

namespace recorded {

enum class Interface : std::uint8_t {
    Link, ///< bytes of the line, link type 147 (USER0)
    Entries, ///< everything else, link type 148 (USER1)
};

struct BlockHead {
    Interface interface = Interface::Entries;
    capture::Nanos at = 0;
    std::uint32_t direction = 0; ///< epb_flags: 0 none, 1 received, 2 sent
    std::uint32_t number = 0;
    std::size_t dataBytes = 0;
};

constexpr std::size_t kBlockOverhead = 68; ///< bytes beside the data and its padding
constexpr std::size_t kFixedHead = 28;

/// Section header and both interfaces: what a file begins with.
/// @param startSeconds  UTC of the session's 0 s
Bytes fileHead(std::int64_t startSeconds, std::string_view program);

/// The data with its frame around it; in place if it has room for kBlockOverhead more. head.dataBytes is not looked at.
Bytes packetBlock(const BlockHead &head, Bytes data);

/// Bytes of the whole block with so much data.
constexpr std::size_t blockSize(std::size_t dataBytes)
{
    return kBlockOverhead + (dataBytes + 3) / 4 * 4;
}

/// The head of the packet block at the beginning of `bytes` and its checked numbers. Empty: not one of ours, damaged,
/// or with more than `most` bytes of data. It wants the whole block; blockLength() says how much that is.
std::optional<BlockHead> packetHead(ByteView block, std::size_t most);

/// The data behind a head that packetHead() has read; empty if their checksum does not fit.
std::optional<ByteView> packetData(const BlockHead &head, ByteView block);

/// What the eight bytes in front of a block claim: type and total length.
struct Claim {
    std::uint32_t type = 0;
    std::uint32_t length = 0;
};
constexpr std::size_t kClaimBytes = 8;
Claim claimOf(ByteView bytes);

constexpr std::uint32_t kSectionBlock = 0x0A0D0D0A;
constexpr std::uint32_t kInterfaceBlock = 1;
constexpr std::uint32_t kPacketBlock = 6;

/// A little-endian section header at the beginning of `bytes`?
bool isSectionHead(ByteView bytes);

} // namespace recorded
