#include "fcp/protocol.h"

#include <array>

namespace fcp {
namespace {

constexpr std::array<std::string_view, 13> kErrors = {"NONE", "BAD_FRAME_ID", "SET_READ_ONLY",
    "GET_WRITE_ONLY", "NO_TARGET_DRIVE", "WRONG_SET", "CMD_ID_NOT_USED", "WRONG_CMD", "OVERRUN",
    "TIMEOUT", "BAD_CRC", "BAD_MOTOR_SELECTED", "MP_NOT_ENABLED"};

} // namespace

std::string_view errorName(std::uint8_t code)
{
    return code < kErrors.size() ? kErrors[code] : std::string_view();
}

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
