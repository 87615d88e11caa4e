// Numbers and bytes as hexadecimal digits, for people and for files.
#pragma once

#include "base/bytes.h"

constexpr std::string_view kUpperHex = "0123456789ABCDEF", kLowerHex = "0123456789abcdef";

/// The last `count` digits of a number.
inline std::string hexDigits(std::uint64_t number, int count, std::string_view digits = kUpperHex)
{
    std::string text;
    for (int shift = 4 * (count - 1); shift >= 0; shift -= 4)
        text.push_back(digits[number >> shift & 0xFU]);
    return text;
}

/// Two digits a byte, with a text between two of them.
inline std::string hexOf(
    ByteView bytes, std::string_view between = "", std::string_view digits = kUpperHex)
{
    std::string text;
    for (const std::uint8_t byte : bytes)
        text.append(text.empty() ? "" : between).append(hexDigits(byte, 2, digits));
    return text;
}
