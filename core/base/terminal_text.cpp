#include "base/terminal_text.h"

#include "base/text.h"

#include <array>
#include <cstdint>

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

struct Character {
    char32_t code = 0;
    std::size_t bytes = 1;
    bool valid = false;
};

struct Form {
    std::uint8_t mask, head; ///< of the first byte
    std::size_t bytes;
    char32_t least; ///< shorter forms of the same character are none
};
constexpr std::array<Form, 4> kForms{
    {{0x80, 0x00, 1, 0}, {0xE0, 0xC0, 2, 0x80}, {0xF0, 0xE0, 3, 0x800}, {0xF8, 0xF0, 4, 0x10000}}};

/// The first character of a text that is not empty.
Character firstOf(std::string_view text)
{
    const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(text[at]); };
    for (const Form &form : kForms) {
        if ((byte(0) & form.mask) != form.head)
            continue;
        char32_t code = byte(0) & static_cast<std::uint8_t>(~form.mask);
        for (std::size_t i = 1; i < form.bytes; ++i) {
            if (i >= text.size() || (byte(i) & 0xC0U) != 0x80)
                return {};
            code = code << 6U | (byte(i) & 0x3FU);
        }
        const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
        if (code < form.least || code > 0x10FFFF || surrogate)
            return {};
        return {code, form.bytes, true};
    }
    return {};
}

/// C0, delete and C1: terminals act on these.
bool isControl(char32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

/// Unicode's Cf, Zl and Zp as far as they direct or hide text.
bool formats(char32_t code)
{
    return code == 0xAD || code == 0x61C || code == 0x180E || (code >= 0x200B && code <= 0x200F)
        || (code >= 0x2028 && code <= 0x202E) || (code >= 0x2060 && code <= 0x206F)
        || code == 0xFEFF || (code >= 0xFFF9 && code <= 0xFFFB)
        || (code >= 0xE0000 && code <= 0xE007F);
}

void appendUnit(std::string &text, char32_t unit) { text += "\\u" + hexDigits(unit, 4, kLowerHex); }

void appendEscape(std::string &text, char32_t code)
{
    if (code < 0x10000)
        return appendUnit(text, code);
    appendUnit(text, 0xD800 + ((code - 0x10000) >> 10U));
    appendUnit(text, 0xDC00 + ((code - 0x10000) & 0x3FFU));
}

} // namespace

std::string terminalText(std::string_view utf8)
{
    std::string text;
    text.reserve(utf8.size());
    while (!utf8.empty()) {
        const Character first = firstOf(utf8);
        if (!first.valid || formats(first.code))
            text += kReplacement;
        else if (isControl(first.code))
            text += ' ';
        else
            text += utf8.substr(0, first.bytes);
        utf8.remove_prefix(first.bytes);
    }
    return text;
}

std::string terminalJson(std::string_view json)
{
    std::string text;
    text.reserve(json.size());
    while (!json.empty()) {
        const Character first = firstOf(json);
        if (!first.valid)
            text += kReplacement;
        else if (first.code == '\n' || first.code == '\t' || first.code == '\r')
            text += ' '; // between tokens only: a text has them escaped
        else if (isControl(first.code) || formats(first.code))
            appendEscape(text, first.code);
        else
            text += json.substr(0, first.bytes);
        json.remove_prefix(first.bytes);
    }
    return text;
}
