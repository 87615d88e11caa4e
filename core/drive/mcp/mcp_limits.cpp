#include "drive/mcp/mcp_limits.h"

#include "mcp/protocol.h"

#include <cmath>

namespace drive {

namespace {

std::string refuseDigits(const McpBoard &board, int motor, double digits)
{
    const double amps = board.ampsPerDigit(motor);
    if (!(amps > 0.0))
        return "the current scale of motor " + std::to_string(motor) + " is not known";
    return refuseCurrent(board, motor, digits * amps);
}

std::string refuseRaw(const McpBoard &board, std::uint16_t bare, int motor, const Bytes &bytes)
{
    const bool ramp = bare == mcp::reg::kSpeedRamp.bits || bare == mcp::reg::kTorqueRamp.bits;
    const std::size_t needed = ramp ? 6 : bare == mcp::reg::kCurrentRef.bits ? 4 : bytes.size();
    if (bytes.size() != needed) // firmware takes what is missing from an older packet
        return "takes " + std::to_string(needed) + " bytes";
    ByteReader reader(bytes);
    if (bare == mcp::reg::kSpeedRamp.bits)
        return refuseSpeed(board, motor, reader.s32());
    if (bare == mcp::reg::kTorqueRamp.bits)
        return refuseDigits(board, motor, reader.s32());
    if (bare == mcp::reg::kCurrentRef.bits) {
        const double iq = reader.s16(), id = reader.s16();
        return refuseDigits(board, motor, std::hypot(iq, id));
    }
    return {};
}

} // namespace

std::string refuseSetPoint(const McpBoard &board, const RegisterWrite &write)
{
    const auto *info = board.catalog->find(write.id);
    if (info == nullptr)
        return {};
    if (const auto *bytes = std::get_if<Bytes>(&write.value))
        return board.hso ? std::string()
                         : refuseRaw(board, static_cast<std::uint16_t>(info->id),
                             board.catalog->motorOf(write.id), *bytes);
    return refuseNumber(board, write);
}

} // namespace drive
