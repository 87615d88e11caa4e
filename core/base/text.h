// Numbers, bytes and words as text, and back: decimal with a point whatever the locale, hexadecimal digits, and tables
// of words.
#pragma once

#include "base/bytes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

/// The shortest text that is the same number again.
inline std::string decimalText(double value)
{
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// With so many digits that count.
inline std::string decimalText(double value, int digits)
{
    std::array<char, 32> text{};
    char *const end = text.data() + text.size();
    return {text.data(),
        std::to_chars(text.data(), end, value, std::chars_format::general, digits).ptr};
}

/// For a sentence: six digits, the point as the decimal sign.
inline std::string shortNumber(double value) { return decimalText(value, 6); }

/// std::from_chars for a number with a point, made of a stream: some libraries have none (Apple's, before LLVM 20).
std::from_chars_result decimalOfStream(const char *first, const char *last, double &value);

/// std::from_chars for a number with a point, wherever this is built.
inline std::from_chars_result readDecimal(const char *first, const char *last, double &value)
{
#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
    return std::from_chars(first, last, value);
#else
    return decimalOfStream(first, last, value);
#endif
}

/// The number that is the whole text; empty if there is none or more, or if it does not fit.
/// @param base  of a whole number
template <class Number>
std::optional<Number> numberIn(std::string_view text, [[maybe_unused]] int base = 10)
{
    Number value{};
    const char *const last = text.data() + text.size();
    std::from_chars_result read{};
    if constexpr (std::same_as<Number, double>)
        read = readDecimal(text.data(), last, value);
    else
        read = std::from_chars(text.data(), last, value, base);
    return read.ec == std::errc{} && read.ptr == last ? std::optional(value) : std::nullopt;
}

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

/// The bytes that pairs of digits spell, with blanks anywhere; empty if there is anything else.
inline std::optional<Bytes> bytesIn(std::string_view hex)
{
    std::string digits(hex);
    std::erase(digits, ' ');
    Bytes bytes;
    for (std::string_view rest = digits; !rest.empty(); rest.remove_prefix(2)) {
        const auto byte = numberIn<std::uint8_t>(rest.substr(0, 2), 16);
        if (!byte || rest.size() < 2)
            return std::nullopt;
        bytes.push_back(*byte);
    }
    return bytes;
}

/// A row of a table of words.
template <class T>
struct Word {
    std::string_view text;
    T meaning;
};

/// What the word stands for; nullptr if it is not in the table.
template <class T, std::size_t N>
const T *findWord(const Word<T> (&words)[N], std::string_view text)
{
    const auto at = std::ranges::find(words, text, &Word<T>::text);
    return at == std::end(words) ? nullptr : &at->meaning;
}

/// The first word that stands for the meaning; the last one of the table if none does.
template <class T, std::size_t N>
constexpr std::string_view wordFor(const Word<T> (&words)[N], T meaning)
{
    return std::ranges::find(
        std::begin(words), std::prev(std::end(words)), meaning, &Word<T>::meaning)
        ->text;
}
