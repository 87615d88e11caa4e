// Frames of the older serial protocol. Values in, values out: no buffers kept, no state.
//
// Wire layout: header | number of payload bytes, 0..127 | payload | checksum. The checksum adds the two bytes of the
// 16-bit sum of all that comes before it; a carry of that addition is lost.
// Source: firmware 5.4.3; the printed text allows 128 bytes, firmware drops such frames without an answer.
#pragma once

#include "base/bytes.h"

#include <cstdint>

namespace legacy {

constexpr std::size_t kMaxPayload = 127;
constexpr std::size_t kFrameOverhead = 3; ///< header, length, checksum

struct Frame {
    std::uint8_t header = 0;
    Bytes payload;
    bool operator==(const Frame &) const = default;
};

/// Of header, length and payload. Exact for any length that a frame can have.
std::uint8_t checksumOf(ByteView bytes);

/// The bytes for the wire; empty if the payload is longer than kMaxPayload.
Bytes encodeFrame(std::uint8_t header, ByteView payload);

} // namespace legacy
