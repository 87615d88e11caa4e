#include "recorded/crc32.h"

#include <array>

namespace recorded {

namespace {

/// Table k: the CRC of a byte with k zero bytes behind it, so that eight bytes go in one step.
constexpr std::size_t kSlices = 8;
using Tables = std::array<std::array<std::uint32_t, 256>, kSlices>;

constexpr Tables makeTables()
{
    Tables tables{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t crc = i;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1U) != 0 ? (crc >> 1) ^ 0xEDB88320U : crc >> 1;
        tables[0][i] = crc;
    }
    for (std::size_t k = 1; k < kSlices; ++k) {
        for (std::size_t i = 0; i < 256; ++i)
            tables[k][i] = (tables[k - 1][i] >> 8) ^ tables[0][tables[k - 1][i] & 0xFFU];
    }
    return tables;
}

constexpr Tables kTables = makeTables();

} // namespace

std::uint32_t crc32(ByteView bytes)
{
    std::uint32_t crc = 0xFFFFFFFFU;
    for (; bytes.size() >= kSlices; bytes = bytes.subspan(kSlices)) {
        std::uint32_t next = kTables[7][(crc ^ bytes[0]) & 0xFFU]
            ^ kTables[6][(crc >> 8 ^ bytes[1]) & 0xFFU] ^ kTables[5][(crc >> 16 ^ bytes[2]) & 0xFFU]
            ^ kTables[4][(crc >> 24 ^ bytes[3]) & 0xFFU];
        for (std::size_t i = 4; i < kSlices; ++i)
            next ^= kTables[kSlices - 1 - i][bytes[i]];
        crc = next;
    }
    for (const std::uint8_t byte : bytes)
        crc = (crc >> 8) ^ kTables[0][(crc ^ byte) & 0xFFU];
    return ~crc;
}

} // namespace recorded
