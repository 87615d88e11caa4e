#include "fcp/protocol.h"

#include <array>

namespace fcp {
namespace {

constexpr std::array<std::string_view, 15> kCommands = {"", "START_MOTOR", "STOP_MOTOR",
    "STOP_RAMP", "RESET", "PING", "START_STOP", "FAULT_ACK", "ENCODER_ALIGN", "IQDREF_CLEAR",
    "PFC_ENABLE", "PFC_DISABLE", "PFC_FAULT_ACK", "PROFILER_START", "PROFILER_STOP"};

constexpr std::array<std::string_view, 13> kErrors = {"NONE", "BAD_FRAME_ID", "SET_READ_ONLY",
    "GET_WRITE_ONLY", "NO_TARGET_DRIVE", "WRONG_SET", "CMD_ID_NOT_USED", "WRONG_CMD", "OVERRUN",
    "TIMEOUT", "BAD_CRC", "BAD_MOTOR_SELECTED", "MP_NOT_ENABLED"};

template <std::size_t Count>
std::string_view nameIn(const std::array<std::string_view, Count> &names, std::uint8_t number)
{
    return number < Count ? names[number] : std::string_view{};
}

} // namespace

std::string_view commandName(std::uint8_t id) { return nameIn(kCommands, id); }

std::string_view errorName(std::uint8_t code) { return nameIn(kErrors, code); }

bool knowsFrame(Dialect dialect, std::uint8_t code)
{
    if (code >= 0x01 && code <= 0x03)
        return true;
    if (dialect == Dialect::PowerPc)
        return code >= 0x06 && code <= 0x0A;
    return (code >= 0x06 && code <= 0x0D) || code == 0x12;
}

bool knowsCommand(Dialect dialect, std::uint8_t id)
{
    if (dialect == Dialect::PowerPc)
        return (id >= 0x01 && id <= 0x03) || (id >= 0x06 && id <= 0x08);
    return id >= 0x01 && id <= 0x0E;
}

} // namespace fcp
