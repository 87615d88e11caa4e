#include "fcp_words.h"

namespace sim {

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
        if (!flags || *flags > 0xFFFFFFFF)
            return fail(std::string("faults takes up to eight hexadecimal digits"));
        board.setFlags(static_cast<std::uint32_t>(*flags));
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
