#include "fcp_words.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace sim {

namespace {

std::optional<std::uint32_t> number(std::string_view text, int base)
{
    if (base == 16 && (text.starts_with("0x") || text.starts_with("0X")))
        text.remove_prefix(2);
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

/// Without the blanks before and behind it.
std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t\r";
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

} // namespace

Result<Obeyed, std::string> obeyFcp(std::string_view line, simulation::FcpBoard &board)
{
    const std::string_view words = trimmed(line);
    const std::string_view word = words.substr(0, words.find_first_of(" \t"));
    const std::string_view rest = trimmed(words.substr(word.size()));
    if (word == "state") {
        const auto state = number(rest, 10);
        if (!state || *state > 0xFF)
            return fail(std::string("state takes a number up to 255"));
        board.setState(static_cast<std::uint8_t>(*state));
    } else if (word == "faults") {
        const auto flags = number(rest, 16);
        if (!flags)
            return fail(std::string("faults takes up to eight hexadecimal digits"));
        board.setFlags(*flags);
    } else if (word == "execute") {
        board.executeBuffered();
    } else if (word == "rx-timeout") {
        board.expireFrame();
    } else if (word == "rx-overrun") {
        board.overrun();
    } else {
        return obey(line, board);
    }
    return Obeyed::Done;
}

} // namespace sim
