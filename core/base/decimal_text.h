// Numbers as decimal text, with a point whatever the locale.
#pragma once

#include <array>
#include <charconv>
#include <string>

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
