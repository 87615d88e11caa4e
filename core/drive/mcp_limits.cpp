#include "drive/mcp_limits.h"

#include "drive/mcp_values.h"
#include "mcp/protocol.h"

#include <charconv>
#include <cmath>
#include <string_view>

namespace drive {

namespace {

std::string number(double value)
{
    char text[32];
    const auto end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr;
    return {text, end};
}

std::string_view nameOf(LimitGap gap)
{
    switch (gap) {
    case LimitGap::MaxSpeed:
        return "greatest speed";
    case LimitGap::MaxCurrent:
        return "greatest current";
    case LimitGap::NominalCurrent:
        break;
    }
    return "nominal current";
}

std::string unknown(const std::string &what, int motor)
{
    return "the board does not tell the " + what + " of motor " + std::to_string(motor)
        + "; to move it all the same takes expert mode";
}

std::string beyond(double bound, std::string_view unit, bool own)
{
    return "beyond " + std::string(own ? "your own limit of " : "the limit of ") + number(bound)
        + std::string(unit);
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

std::string refuseStart(const McpBoard &board, int motor)
{
    if (board.expert.contains(motor))
        return {};
    std::string names;
    for (const LimitGap gap : gapsIn(board.limitsOf(motor)))
        names += (names.empty() ? "" : ", ") + std::string(nameOf(gap));
    return names.empty() ? names : unknown(names, motor);
}

std::string refuseSpeed(const McpBoard &board, int motor, double rpm)
{
    const double bound = board.boundsOf(motor).rpm;
    if (!std::isfinite(rpm))
        return "not a finite number";
    if (!(bound > 0.0))
        return unknown("speed limit", motor);
    if (std::abs(rpm) > bound)
        return beyond(bound, " rpm", bound == board.user.maxSpeedRpm);
    return {};
}

std::string refuseCurrent(const McpBoard &board, int motor, double amps)
{
    const double bound = board.boundsOf(motor).amps;
    if (!std::isfinite(amps))
        return "not a finite number";
    if (!(bound > 0.0))
        return unknown("current limit", motor);
    if (std::abs(amps) > bound)
        return beyond(bound, " A", bound == board.user.maxCurrentAmps);
    return {};
}

std::string refuseSetPoint(const McpBoard &board, const RegisterWrite &write)
{
    const auto *info = board.catalog->find(write.id);
    if (info == nullptr)
        return {};
    const int motor = board.catalog->motorOf(write.id);
    if (const auto *bytes = std::get_if<Bytes>(&write.value))
        return board.hso ? std::string()
                         : refuseRaw(board, static_cast<std::uint16_t>(info->id), motor, *bytes);
    const auto value = asNumber(write.value);
    if (!value || info->setPoint == catalog::SetPoint::None)
        return {};
    const double perDigit =
        setPointPerDigit(*info, board.catalog->readScale(write.id), board.limitsOf(motor));
    if (!(perDigit > 0.0))
        return "the scale of motor " + std::to_string(motor) + " is not known";
    return info->setPoint == catalog::SetPoint::Speed
        ? refuseSpeed(board, motor, *value * perDigit)
        : refuseCurrent(board, motor, *value * perDigit);
}

} // namespace drive
