// Requests: what a client asks, typed. The encoder refuses what a frame cannot hold; what is safe to ask is decided
// above.
//
// Header: bits 7..5 motor (0: the one selected last), bits 4..0 frame code. Numbers are little-endian.
#pragma once

#include "base/result.h"
#include "fcp/framer.h"
#include "fcp/protocol.h"

#include <optional>
#include <variant>

namespace fcp {

/// A register's new value in 1, 2 or 4 bytes. Firmware fills up what is missing with old bytes: send the full width.
struct SetRegister {
    std::uint8_t id = 0;
    Bytes value;
    bool operator==(const SetRegister &) const = default;
};
struct GetRegister {
    std::uint8_t id = 0;
    bool operator==(const GetRegister &) const = default;
};
struct Execute {
    std::uint8_t command = 0; ///< CommandId, or whatever came
    bool operator==(const Execute &) const = default;
};
struct GetBoardInfo {
    bool operator==(const GetBoardInfo &) const = default;
};
struct GetFirmwareVersion {
    bool operator==(const GetFirmwareVersion &) const = default;
};
struct SetRamp {
    std::int32_t speed_rpm = 0;
    std::uint16_t duration_ms = 0;
    bool operator==(const SetRamp &) const = default;
};
struct GetRevUp {
    std::uint8_t stage = 0; ///< 0..4; firmware reads past its table beyond
    bool operator==(const GetRevUp &) const = default;
};
struct StageFields {
    std::int32_t speed_rpm = 0;
    std::int16_t torque = 0; ///< s16A
    std::uint16_t duration_ms = 0;
    bool operator==(const StageFields &) const = default;
};
struct SetRevUp {
    std::uint8_t stage = 0; ///< 0..4; firmware writes past its table beyond
    StageFields values;
    bool operator==(const SetRevUp &) const = default;
};
struct SetCurrentReference {
    std::int16_t iq = 0, id = 0; ///< s16A
    bool operator==(const SetCurrentReference &) const = default;
};
struct GetProfilerInfo {
    Bytes steps; ///< numbers of the profiler's steps
    bool operator==(const GetProfilerInfo &) const = default;
};
struct SetTorqueRamp {
    std::int32_t torque = 0; ///< s16A; firmware takes the lower 16 bits
    std::uint16_t duration_ms = 0;
    bool operator==(const SetTorqueRamp &) const = default;
};
struct SetPosition {
    float angle_rad = 0.0F, duration_s = 0.0F;
    bool operator==(const SetPosition &) const = default;
};
/// A frame code without a meaning here.
struct OtherRequest {
    std::uint8_t code = 0;
    Bytes payload;
    bool operator==(const OtherRequest &) const = default;
};

using Command = std::variant<SetRegister, GetRegister, Execute, GetBoardInfo, GetFirmwareVersion,
    SetRamp, GetRevUp, SetRevUp, SetCurrentReference, GetProfilerInfo, SetTorqueRamp, SetPosition,
    OtherRequest>;

struct Request {
    std::uint8_t motor = 0; ///< 0..7
    Command command;
    bool operator==(const Request &) const = default;
};

enum class RequestError : std::uint8_t {
    TooShort, ///< firmware would use bytes of an earlier frame
    TooLong, ///< firmware would pass over the rest
    BadWidth, ///< a register's value that has not 1, 2 or 4 bytes
    BadMotor, ///< above 7, or a code above 31
    IsAReply, ///< header of a board's frame
};

/// The whole frame for the wire.
Result<Bytes, RequestError> encodeRequest(const Request &request);

/// What a frame asks; its payload must have exactly the length of its kind.
Result<Request, RequestError> decodeRequest(const Frame &frame);

/// Payload bytes that a frame code calls for; empty where the length is free (SET_REG, GET_MP_INFO, unknown codes).
std::optional<std::size_t> payloadSizeOf(std::uint8_t code);

} // namespace fcp
