// CRC-16/XMODEM by carry-less multiplication, where the processor has it: five to fifteen times as fast as tables.
#pragma once

#include "base/bytes.h"

#include <array>
#include <cstddef>

/// What is left when a message is folded to 16 bytes that have the same CRC.
using Folded = std::array<std::uint8_t, 16>;

constexpr std::size_t kLeastFolding = 128; ///< bytes; tables are as good for less

enum class Folding : std::uint8_t {
    None,
    By16, ///< bytes in a register
    By32,
};

/// The widest that this processor can do.
Folding widestFolding();

/// The CRC-16/XMODEM of the result is that of `bytes`.
/// @param bytes  at least kLeastFolding
/// @param how    not None, and no wider than widestFolding()
/// Source: V. Gopal et al., "Fast CRC Computation for Generic Polynomials Using PCLMULQDQ" (Intel, 2009).
Folded foldForCrc16(ByteView bytes, Folding how);
