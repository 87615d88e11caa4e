// What may be written to this protocol's registers beyond the rules of all protocols: the raw registers that hold
// set-points.
#pragma once

#include "drive/mcp/mcp_protocol.h"
#include "drive/wish.h"

#include <optional>
#include <string>

namespace drive {

/// Why this must not be written, as far as it can be told without a look at the board; empty if it may: the rules of all
/// protocols (drive/write_check.h), and the bytes of raw registers.
std::string refuseWriteOf(const McpFacts &board, const RegisterWrite &write, Reach reach);

/// Why stages of a start-up are beyond what the user allows or the protocol can hold; empty if they are not.
std::string refuseStages(const McpFacts &board, int motor, ByteView raw);

constexpr const char *kPosition = "CURRENT_POSITION"; ///< the register of where a shaft is

/// Where a position ramp goes.
struct RawPosition {
    double radians = 0.0, seconds = 0.0;
};
/// Of POSITION_RAMP; empty if it has another length.
std::optional<RawPosition> positionIn(const Bytes &bytes);
/// Why the shaft must not go there, wherever it is now; empty if it may.
std::string refusePosition(const McpFacts &board, int motor, const RawPosition &wanted);
/// The same from where it is, because of the speed on the way.
std::string refuseWay(
    const McpFacts &board, int motor, const RawPosition &wanted, double position_rad);

} // namespace drive
