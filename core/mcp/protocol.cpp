#include "mcp/protocol.h"

#include <array>

namespace mcp {
namespace {

constexpr std::array<std::string_view, 17> kCommands = {"GET_MCP_VERSION", "SET_REGISTER",
    "GET_REGISTER", "START_MOTOR", "STOP_MOTOR", "STOP_RAMP", "START_STOP", "FAULT_ACK",
    "CPULOAD_CLEAR", "IQDREF_CLEAR", "PFC_ENABLE", "PFC_DISABLE", "PFC_FAULT_ACK", "PROFILER_CMD",
    "", "SW_RESET", "SENSOR_SWITCH"};

constexpr std::array<std::string_view, 14> kStatuses = {"CMD_OK", "CMD_NOK", "CMD_UNKNOWN",
    "DATAID_UNKNOWN", "RO_REG", "UNKNOWN_REG", "STRING_FORMAT", "BAD_DATA_TYPE", "NO_TXSYNC_SPACE",
    "NO_TXASYNC_SPACE", "BAD_RAW_FORMAT", "WO_REG", "REGISTER_ACCESS", "CALLBACK_NOT_REGISTERED"};

} // namespace

std::string_view commandName(std::uint16_t commandId)
{
    if (commandId < kCommands.size())
        return kCommands[commandId];
    const bool user = commandId >= static_cast<std::uint16_t>(CommandId::UserFirst)
        && commandId <= static_cast<std::uint16_t>(CommandId::UserLast);
    return user ? "USER_CMD" : std::string_view{};
}

std::string_view statusName(std::uint8_t status)
{
    return status < kStatuses.size() ? kStatuses[status] : std::string_view{};
}

} // namespace mcp
