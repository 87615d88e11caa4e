#include "base/crc.h"

#include "base/crc_folding.h"

#include <array>

namespace {

constexpr std::array<std::uint8_t, 16> kCrc4 = {
    0x0, 0x7, 0xE, 0x9, 0xB, 0xC, 0x5, 0x2, 0x1, 0x6, 0xF, 0x8, 0xA, 0xD, 0x4, 0x3};

constexpr std::array<std::uint16_t, 256> makeCrc16Table()
{
    std::array<std::uint16_t, 256> table{};
    for (unsigned i = 0; i < 256; ++i) {
        unsigned crc = i << 8;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 0x8000U) != 0 ? (crc << 1) ^ 0x1021U : crc << 1;
        table[i] = static_cast<std::uint16_t>(crc);
    }
    return table;
}

/// Table k: the CRC of a byte with k zero bytes behind it. With 16 of them 16 bytes go in one step and without waiting
/// for each other, some nine times as fast as byte after byte.
constexpr std::size_t kSlices = 16;
using Crc16Tables = std::array<std::array<std::uint16_t, 256>, kSlices>;

constexpr Crc16Tables makeCrc16Tables()
{
    Crc16Tables tables{};
    tables[0] = makeCrc16Table();
    for (std::size_t k = 1; k < kSlices; ++k) {
        for (std::size_t i = 0; i < 256; ++i) {
            const unsigned before = tables[k - 1][i];
            tables[k][i] = static_cast<std::uint16_t>((before << 8) ^ tables[0][before >> 8]);
        }
    }
    return tables;
}

constexpr Crc16Tables kCrc16 = makeCrc16Tables();

std::uint16_t crcByTable(ByteView bytes)
{
    unsigned crc = 0;
    for (; bytes.size() >= kSlices; bytes = bytes.subspan(kSlices)) {
        unsigned next = kCrc16[15][bytes[0] ^ (crc >> 8)] ^ kCrc16[14][bytes[1] ^ (crc & 0xFFU)];
        for (std::size_t i = 2; i < kSlices; ++i)
            next ^= kCrc16[kSlices - 1 - i][bytes[i]];
        crc = next;
    }
    for (const std::uint8_t byte : bytes)
        crc = ((crc << 8) ^ kCrc16[0][((crc >> 8) ^ byte) & 0xFFU]) & 0xFFFFU;
    return static_cast<std::uint16_t>(crc);
}

} // namespace

std::uint8_t crc4(std::uint32_t bits28)
{
    std::uint8_t crc = 0;
    for (int shift = 0; shift < 28; shift += 4)
        crc = kCrc4[crc ^ ((bits28 >> shift) & 0xFU)];
    return crc;
}

std::uint16_t crc16Xmodem(ByteView bytes)
{
    if (bytes.size() >= kLeastFolding && widestFolding() != Folding::None)
        return crcByTable(foldForCrc16(bytes, widestFolding()));
    return crcByTable(bytes);
}
