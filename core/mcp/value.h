// Register values on the wire and what they mean. Every length is bounded by the bytes at hand.
//
// Encodings, by the type field of the register: 8, 16, 32 bits little-endian; strings with a terminating zero and no
// length; raw values behind a u16 size that does not count itself.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "catalog/register_info.h"
#include "mcp/protocol.h"

#include <cstdint>
#include <string>
#include <variant>

namespace mcp {

enum class CodecError : std::uint8_t {
    TooShort, ///< the bytes end within a value
    NoTerminator, ///< a string without its zero
    BadType, ///< the type field is not 1..5
    WrongKind, ///< a number where a text is due, or the like
    OutOfRange, ///< does not fit the register's width
    TooLong, ///< more than the peer can take
    Leftover, ///< bytes behind the last value
    Empty, ///< a list without a register, a response without its status
    NoMotor, ///< a motor command without a motor: firmware would index outside its array
    WrongSize, ///< a structure of a size that no firmware has
};

/// As it crosses the wire: the bits of a scalar (not sign-extended), a text, or the content of a raw value.
using Value = std::variant<std::uint32_t, std::string, Bytes>;

Result<Value, CodecError> decodeValue(RegisterId id, ByteReader &reader);

/// Appends `value` as register `id` wants it; writes nothing on error. A text loses what follows a zero in it.
Result<void, CodecError> encodeValue(RegisterId id, const Value &value, ByteWriter &writer);

/// The number behind the bits of a scalar: sign-extended or a float, as the format says. Texts and raw stay as they
/// are.
catalog::Value interpret(const Value &value, catalog::ValueType type);

/// The bits for a number. Integers must fit the format; a double must be finite, and for integer formats whole.
Result<Value, CodecError> bitsOf(const catalog::Value &value, catalog::ValueType type);

/// The usual format of a register that no table knows: unsigned, by the width in its id.
catalog::ValueType plainType(RegisterId id);

} // namespace mcp
