#include "drive/mcp/limits.h"

#include "drive/values.h"
#include "drive/write_check.h"
#include "mcp/protocol.h"

#include <cmath>

namespace drive {

namespace {

std::string refuseTorqueDigits(const McpFacts &board, int motor, double iq, double id)
{
    const double digits = std::hypot(iq, id);
    if (digits != 0.0)
        if (auto why = refuseTorqueControl(board); !why.empty())
            return why;
    if (auto why = board.reasonAgainstAmps(motor); !why.empty())
        return why;
    if (auto why = refuseCurrent(board, motor, leastAmps(digits, board.ampsPerDigit(motor)));
        !why.empty())
        return why;
    return refuseDigits(digits);
}

/// How long the bytes of a set-point are; 0: it is none.
std::size_t lengthOf(std::uint16_t bare)
{
    return bare == mcp::reg::kSpeedRamp.bits || bare == mcp::reg::kTorqueRamp.bits ? 6
        : bare == mcp::reg::kCurrentRef.bits                                       ? 4
        : bare == mcp::reg::kPositionRamp.bits                                     ? 8
                                                                                   : 0;
}

std::string refuseRaw(const McpFacts &board, std::uint16_t bare, int motor, const Bytes &bytes)
{
    const std::size_t needed = lengthOf(bare);
    if (needed > 0 && bytes.size() != needed) // firmware takes what is missing from an older packet
        return "takes " + std::to_string(needed) + " bytes";
    ByteReader reader(bytes);
    if (bare == mcp::reg::kSpeedRamp.bits)
        return refuseWireSpeed(board, motor, reader.s32());
    if (bare == mcp::reg::kTorqueRamp.bits)
        return refuseTorqueDigits(board, motor, reader.s32(), 0.0);
    if (bare == mcp::reg::kCurrentRef.bits) {
        const double iq = reader.s16(), id = reader.s16();
        return refuseTorqueDigits(board, motor, iq, id);
    }
    if (bare == mcp::reg::kPositionRamp.bits)
        return refusePosition(board, motor, *positionIn(bytes));
    if (bare == mcp::reg::kRevUpData.bits)
        return refuseStages(board, motor, bytes);
    return {};
}

} // namespace

std::string refuseWriteOf(const McpFacts &board, const RegisterWrite &write, Reach reach)
{
    if (auto why = refuseWrite(board, write, reach); !why.empty())
        return why;
    const auto &info = *board.catalog->find(write.id);
    const int motor = board.catalog->motorOf(write.id);
    if (info.id == mcp::reg::kSpeedRef.bits && !board.hso)
        return refuseWireSpeed(board, motor, asNumber(write.value).value_or(NAN));
    const auto *bytes = std::get_if<Bytes>(&write.value);
    return bytes == nullptr || board.hso
        ? std::string()
        : refuseRaw(board, static_cast<std::uint16_t>(info.id), motor, *bytes);
}

std::optional<Move> positionIn(const Bytes &bytes)
{
    if (bytes.size() != lengthOf(mcp::reg::kPositionRamp.bits))
        return std::nullopt;
    ByteReader reader(bytes);
    return Move{reader.f32(), reader.f32()};
}

} // namespace drive
