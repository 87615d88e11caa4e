// Responses: what a Performer answers. The command's answer comes first, one status byte last.
#pragma once

#include "mcp/value.h"

#include <optional>
#include <span>
#include <vector>

namespace mcp {

struct Response {
    std::uint8_t status = 0;
    ByteView data; ///< of the payload that was decoded, without the status
    bool ok() const { return status == static_cast<std::uint8_t>(Status::Ok); }
};

/// Fails only for an empty payload.
Result<Response, CodecError> decodeResponse(ByteView payload);

/// How a command, or a SET of one register, ended: two bytes where a value was not parsed to its end (0A 01, 07 01),
/// the first is the register's. Nothing: the response is longer.
std::optional<std::uint8_t> statusOf(const Response &response);

/// The values of a GET for as many registers as were answered. If `status` is not Ok it is about the register behind
/// the last value, ids[values.size()]; those behind that one were not looked at.
struct GetAnswer {
    std::vector<Value> values;
    std::uint8_t status = 0;
};

/// A response that does not fit the ids is an error: it belongs to another request, or was damaged. So is one that has
/// all the values, and refuses.
Result<GetAnswer, CodecError> decodeGetAnswer(
    std::span<const RegisterId> ids, const Response &response);

/// One status a register of a SET, in order. Fewer than were sent: the board stopped there, `status` says why.
struct SetAnswer {
    std::vector<std::uint8_t> registers;
    std::uint8_t status = 0;
};

/// @param count  registers in the request
/// Special cases: one status alone is about all; a single register has what statusOf() tells. More statuses than
/// registers are an error, and so are several without a NOK behind them.
Result<SetAnswer, CodecError> decodeSetAnswer(std::size_t count, const Response &response);

/// The version of GET_MCP_VERSION: the low byte of four, the others are left-overs of earlier responses.
std::optional<std::uint8_t> versionOf(const Response &response);

} // namespace mcp
