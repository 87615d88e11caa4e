// The checksum of recordings.
#pragma once

#include "base/bytes.h"

namespace recorded {

/// CRC-32 of IEEE 802.3 (reflected 0x04C11DB7, start and final XOR 0xFFFFFFFF), as in zlib and in pcapng's epb_hash.
std::uint32_t crc32(ByteView bytes);

} // namespace recorded
