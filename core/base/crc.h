// The checksums of the wire.
#pragma once

#include "base/bytes.h"

#include <cstdint>

/// CRC-4 of the low 28 bits of an ASPEP header, for its bits 28-31. Generator x^4+x^2+x+1, start 0, nibbles from
/// the lowest, high bit of each nibble first. The printed text and the firmware's comments say x^4+x+1; the tables
/// in every firmware, and every captured packet, say otherwise.
std::uint8_t crc4(std::uint32_t bits28);

/// CRC-16/XMODEM (0x1021, start 0, no final XOR). No shipped firmware computes a payload CRC; this is the reading
/// of the printed text that is used where both sides ask for one.
std::uint16_t crc16Xmodem(ByteView bytes);
