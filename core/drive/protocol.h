// Which language is spoken on a line, as the user chooses it. The one place where the protocols are named for people.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace drive {

enum class Protocol : std::uint8_t {
    Auto, ///< found out by asking, without a byte that could move anything
    Mcp,
    Fcp,
    PowerPc,
    Mcb,
};

struct ProtocolChoice {
    Protocol protocol = Protocol::Auto;
    std::string_view word; ///< for command lines and files, e.g. "mcp"
    std::string_view title; ///< its proper name; empty: it has none, and a window says what it is
    std::string_view help; ///< what speaks it
    bool serial = true; ///< spoken on a serial port
};

std::string_view wordOf(Protocol protocol);
std::optional<Protocol> protocolOf(std::string_view word);

} // namespace drive
