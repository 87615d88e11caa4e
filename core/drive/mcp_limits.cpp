#include "drive/mcp_limits.h"

#include "drive/mcp_values.h"
#include "mcp/protocol.h"

#include <charconv>
#include <cmath>

namespace drive {

namespace {

std::string number(double value)
{
    char text[32];
    const auto end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr;
    return {text, end};
}

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

std::string refuseSpeed(const McpBoard &board, int motor, double rpm)
{
    const double limit = board.limitsOf(motor).maxSpeedRpm;
    if (!std::isfinite(rpm))
        return "not a finite number";
    if (!(limit > 0.0))
        return "the speed limit of motor " + std::to_string(motor) + " is not known";
    if (std::abs(rpm) > limit)
        return "beyond the limit of " + number(limit) + " rpm";
    return {};
}

std::string refuseCurrent(const McpBoard &board, int motor, double amps)
{
    const MotorLimits limits = board.limitsOf(motor);
    double limit = limits.maxCurrentAmps;
    if (limits.nominalCurrentAmps > 0.0 && (!(limit > 0.0) || limits.nominalCurrentAmps < limit))
        limit = limits.nominalCurrentAmps;
    if (!std::isfinite(amps))
        return "not a finite number";
    if (!(limit > 0.0))
        return "the current limit of motor " + std::to_string(motor) + " is not known";
    if (std::abs(amps) > limit)
        return "beyond the limit of " + number(limit) + " A";
    return {};
}

std::string refuseSetPoint(const McpBoard &board, const RegisterWrite &write)
{
    const auto *info = board.catalog->find(write.id);
    if (info == nullptr || board.hso)
        return {};
    const int motor = board.catalog->motorOf(write.id);
    if (const auto *bytes = std::get_if<Bytes>(&write.value))
        return refuseRaw(board, static_cast<std::uint16_t>(info->id), motor, *bytes);
    const auto value = asNumber(write.value);
    if (!value)
        return {};
    switch (info->setPoint) {
    case catalog::SetPoint::Speed:
        return refuseSpeed(board, motor, *value);
    case catalog::SetPoint::Current:
        return refuseDigits(board, motor, *value);
    case catalog::SetPoint::None:
        break;
    }
    return {};
}

} // namespace drive
