// Samples as packets interleave them, block after block, to columns, signal after signal.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mcp {

/// @param from     `blocks` blocks of `signals` little-endian 16-bit samples
/// @param to       the first sample of signal 0; that of signal s is at to + s * pitch
/// Cost: about one copy of the bytes for 4 and 8 signals, two to three for others.
void deinterleave(const std::uint8_t *from, std::size_t signals, std::size_t blocks,
    std::int16_t *to, std::size_t pitch);

/// The same without the instructions of one processor: what others run, and what the fast one is held against.
void deinterleavePortable(const std::uint8_t *from, std::size_t signals, std::size_t blocks,
    std::int16_t *to, std::size_t pitch);

} // namespace mcp
