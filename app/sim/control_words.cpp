// Parsing a control word and doing it.
#include "control_words.h"

#include "base/text.h"

#include <optional>

namespace sim {

std::string_view trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::optional<std::uint64_t> number(std::string_view text, int base)
{
    if (base == 16 && (text.starts_with("0x") || text.starts_with("0X")))
        text.remove_prefix(2);
    return numberIn<std::uint64_t>(text, base);
}

namespace {

/// "load 0.05" or "load 0.05 2": the brake of a motor, the first if none is named.
std::optional<std::string> loadMotor(std::string_view words, simulation::SimulatedBoard &board)
{
    constexpr double kMost_nm = 1000.0;
    const std::size_t space = words.find_first_of(" \t");
    const std::string_view amount = words.substr(0, space);
    const std::string_view which =
        space == std::string_view::npos ? std::string_view("1") : trimmed(words.substr(space));
    const auto nm = numberIn<double>(amount);
    const auto motor = number(which, 10);
    if (!nm || !(*nm >= 0.0 && *nm <= kMost_nm) || !motor || *motor < 1 || *motor > 2)
        return "load takes a torque in Nm, 0 to 1000, and perhaps the number of a motor";
    board.setLoadTorque(static_cast<int>(*motor), *nm);
    return std::nullopt;
}

} // namespace

Result<Obeyed, std::string> obey(std::string_view line, simulation::SimulatedBoard &board)
{
    line = trimmed(line);
    const std::string_view word = line.substr(0, line.find_first_of(" \t"));
    const std::string_view rest = trimmed(line.substr(word.size()));
    constexpr std::uint64_t kMuteMost_ms = 3'600'000;
    if (word == "quit")
        return Obeyed::Quit;
    if (word == "reset") {
        board.reset();
    } else if (word == "nofault") {
        board.setFaults(0);
    } else if (word == "fault") {
        const auto bits = number(rest, 16);
        if (!bits || *bits > 0xFFFF)
            return fail(std::string("fault takes up to four hexadecimal digits"));
        board.setFaults(static_cast<std::uint16_t>(*bits));
    } else if (word == "load") {
        if (const auto problem = loadMotor(rest, board))
            return fail(*problem);
    } else if (word == "mute") {
        const auto ms = number(rest, 10);
        if (!ms || *ms > kMuteMost_ms)
            return fail(std::string("mute takes a time in milliseconds"));
        board.mute(std::chrono::milliseconds(*ms));
    } else if (word == "corrupt") {
        const auto bytes = number(rest, 10);
        if (!bytes)
            return fail(std::string("corrupt takes a number of bytes"));
        board.corruptAfter(*bytes);
    } else if (word == "inject") {
        const auto bytes = bytesIn(rest);
        if (!bytes || bytes->empty())
            return fail(std::string("inject takes bytes in hexadecimal digits"));
        board.inject(*bytes);
    } else if (!word.empty()) {
        return fail("there is no word \"" + std::string(word) + '"');
    }
    return Obeyed::Done;
}

Result<Obeyed, std::string> obeyStatic(std::string_view line, const std::function<void()> &reset)
{
    const std::string_view word = trimmed(line);
    if (word == "quit")
        return Obeyed::Quit;
    if (word == "reset")
        reset();
    else if (!word.empty())
        return fail("there is no word \"" + std::string(word) + '"');
    return Obeyed::Done;
}

} // namespace sim
