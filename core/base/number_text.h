// Numbers as text, with a point whatever the locale, and back.
#pragma once

#include <array>
#include <charconv>
#include <concepts>
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

/// The number that is the whole text; empty if there is none or more, or if it does not fit.
/// @param base  of a whole number
template <class Number>
std::optional<Number> numberIn(std::string_view text, [[maybe_unused]] int base = 10)
{
    Number value{};
    const char *const last = text.data() + text.size();
    std::from_chars_result read{};
    if constexpr (std::floating_point<Number>)
        read = std::from_chars(text.data(), last, value);
    else
        read = std::from_chars(text.data(), last, value, base);
    return read.ec == std::errc{} && read.ptr == last ? std::optional(value) : std::nullopt;
}
