// Raw structures as lists of named numbers and texts, for people who read a decoded trace. Padding is left out.
#pragma once

#include "base/bytes.h"
#include "mcp/protocol.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace mcp {

struct Field {
    std::string name; ///< unique within its structure
    std::variant<std::int64_t, double, std::string> value;
};

/// The fields of register `id` in wire order; empty if the register or the size is not known.
std::vector<Field> fieldsOf(RegisterId id, ByteView raw);

} // namespace mcp
