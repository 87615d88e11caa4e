// Register values as numbers, with the range checks that keep nonsense from being encoded. Neutral.
#pragma once

#include "base/result.h"
#include "catalog/register_info.h"

#include <cstdint>
#include <string>

namespace drive {

using catalog::asNumber;
using catalog::Value;

// Why a value is none for a register, in every protocol.
inline constexpr const char *kNotFinite = "not a finite number",
                            *kDoesNotFit = "does not fit the register",
                            *kSetByStreaming = "is set by streaming";

/// What was read is what was written; a board may hold a number in 32 bits only.
bool sameValue(const Value &written, const Value &read);

/// The whole number in a value, also where it came as a floating-point one, if a register of the type holds it. Fails
/// with the reason.
Result<std::int64_t, std::string> wholeNumberFor(catalog::ValueType type, const Value &value);

} // namespace drive
