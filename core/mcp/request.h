// Requests: what a Controller asks. Encoders refuse what firmware mishandles; the decoder reads whatever was recorded.
//
// Payload: u16 command word = (command << 3) | motor, then what the command carries.
#pragma once

#include "mcp/value.h"

#include <optional>
#include <span>
#include <vector>

namespace mcp {

struct RegisterValue {
    RegisterId id;
    Value value;
    bool operator==(const RegisterValue &) const = default;
};

/// GET of one or more registers; never odd, never empty. @param room  what the board takes (Beacon::rxMax())
/// Order the ids 32-bit, 16-bit, 8-bit: small processors of boards cannot write unaligned values (see getOrder()).
Result<Bytes, CodecError> encodeGet(std::span<const RegisterId> ids, std::size_t room);

/// SET of one or more registers.
Result<Bytes, CodecError> encodeSet(std::span<const RegisterValue> writes, std::size_t room);

/// Any other command. Motor commands need motor 1..7; for the others `motor` is sent as it is.
Result<Bytes, CodecError> encodeCommand(CommandId command, unsigned motor, ByteView content = {});

/// Rank of a register in a GET list: 32-bit first, then 16-bit, 8-bit, texts, raw values.
int getOrder(RegisterId id);

/// True for START_MOTOR to FAULT_ACK and their like: firmware uses the motor number unchecked.
bool isMotorCommand(std::uint16_t commandId);

struct Request {
    std::uint16_t command = 0;
    std::uint8_t motor = 0;
    ByteView content; ///< of the payload that was decoded
};

/// Fails for less than 2 bytes.
Result<Request, CodecError> decodeRequest(ByteView payload);

/// The ids of a GET. An odd last byte is an error.
Result<std::vector<RegisterId>, CodecError> decodeGetList(ByteView content);

/// The pairs of a SET, as far as they can be read: `error` says why no further.
struct SetList {
    std::vector<RegisterValue> writes;
    std::optional<CodecError> error;
};
SetList decodeSetList(ByteView content);

} // namespace mcp
