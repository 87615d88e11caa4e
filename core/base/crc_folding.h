// CRC-16/XMODEM by carry-less multiplication, where the processor has it: five to eight times as fast as tables.
#pragma once

#include "base/bytes.h"

#include <array>
#include <cstddef>

/// What is left when a message is folded to 16 bytes that have the same CRC.
using Folded = std::array<std::uint8_t, 16>;

constexpr std::size_t kLeastFolding = 128; ///< bytes; tables are as good for less

/// True if this processor can fold.
bool canFoldCrc16();

/// The CRC-16/XMODEM of the result is that of `bytes`.
/// @param bytes  at least 64. Only where canFoldCrc16().
/// Source: V. Gopal et al., "Fast CRC Computation for Generic Polynomials Using PCLMULQDQ" (Intel, 2009).
Folded foldForCrc16(ByteView bytes);
