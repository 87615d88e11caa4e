// Numbers and texts as JSON writes them, whatever the locale.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

namespace sim {

/// The shortest text that reads back as the same number; JSON has no word for what is not finite, so null.
inline std::string jsonNumber(double value)
{
    if (!std::isfinite(value))
        return "null";
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

/// In quotation marks, with what JSON wants escaped.
inline std::string jsonText(std::string_view text)
{
    static constexpr std::string_view kDigits = "0123456789abcdef";
    std::string quoted = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            quoted += '\\';
        if (code < 0x20) {
            quoted += "\\u00";
            quoted += kDigits[code >> 4U];
            quoted += kDigits[code & 15U];
        } else {
            quoted += c;
        }
    }
    return quoted + '"';
}

} // namespace sim
