#include "drive/protocol.h"

#include <algorithm>
#include <array>

namespace drive {

std::span<const ProtocolChoice> protocolChoices()
{
    using enum Protocol;
    static constexpr std::array kChoices{
        ProtocolChoice{Auto, "auto", "", "", true},
        ProtocolChoice{Mcp, "mcp", "MCP over ASPEP", "STM32 motor control SDK 6", true},
        ProtocolChoice{Legacy, "legacy", "MCP legacy", "STM32 motor control SDK 3 to 5", true},
        ProtocolChoice{PowerPc, "powerpc", "MCP PowerPC", "PowerPC boards", true},
        ProtocolChoice{Mcb, "mcb", "MCB over SPI", "servo drives of Ingenia and Celera", false},
    };
    return kChoices;
}

std::string_view wordOf(Protocol protocol)
{
    for (const ProtocolChoice &choice : protocolChoices())
        if (choice.protocol == protocol)
            return choice.word;
    return "auto";
}

std::optional<Protocol> protocolOf(std::string_view word)
{
    for (const ProtocolChoice &choice : protocolChoices())
        if (choice.word == word)
            return choice.protocol;
    return std::nullopt;
}

} // namespace drive
