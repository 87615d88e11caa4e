#include "base/crc.h"

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

constexpr auto kCrc16 = makeCrc16Table();

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
    unsigned crc = 0;
    for (const std::uint8_t byte : bytes)
        crc = ((crc << 8) ^ kCrc16[((crc >> 8) ^ byte) & 0xFFU]) & 0xFFFFU;
    return static_cast<std::uint16_t>(crc);
}
