// Register values between the wire's bytes and the neutral Value, with the range checks that keep nonsense from being
// encoded. Reasons are short words for the Ended event.
#pragma once

#include "base/result.h"
#include "catalog/catalog.h"
#include "drive/event.h"
#include "drive/values.h"
#include "mcp/value.h"

#include <optional>
#include <string>

namespace drive {

/// The register of one motor.
RegisterId idOf(mcp::RegisterId id, int motor);

/// How a value of this id is stored: the catalogue's word, or unsigned of the width that the id itself tells.
catalog::ValueType typeOf(const catalog::Catalog &catalog, RegisterId id);

/// Bytes a scalar takes in an answer; 0 for texts and raw values, whose length only the answer tells.
std::size_t wireWidth(RegisterId id);

/// The next value of an answer; for raw values the content without its size. Empty if the bytes do not hold one.
std::optional<Value> readValue(ByteReader &bytes, RegisterId id, catalog::ValueType type);

/// As a SET has it. Fails (with the reason) on text, on non-finite numbers and out of the type's range.
Result<mcp::Value, std::string> wireValue(const catalog::RegisterInfo &info, const Value &value);

/// How the answer to a command or a set-point ends its wish.
struct McpEnd {
    Outcome outcome = Outcome::Unknown;
    std::string reason;
};
McpEnd endIn(ByteView response);

/// The firmware's word for a status byte, or the byte in hex.
std::string statusWord(std::uint8_t status);

} // namespace drive
