#include "fcp/request.h"

#include "base/overloaded.h"

namespace fcp {
namespace {

constexpr std::uint8_t codeOf(FrameCode code) { return static_cast<std::uint8_t>(code); }

std::uint8_t frameCodeOf(const Command &command)
{
    return std::visit(
        Overloaded{
            [](const SetRegister &) { return codeOf(FrameCode::SetRegister); },
            [](const GetRegister &) { return codeOf(FrameCode::GetRegister); },
            [](const Execute &) { return codeOf(FrameCode::Execute); },
            [](const GetBoardInfo &) { return codeOf(FrameCode::GetBoardInfo); },
            [](const GetFirmwareVersion &) { return codeOf(FrameCode::GetFirmwareVersion); },
            [](const SetRamp &) { return codeOf(FrameCode::SetRamp); },
            [](const GetRevUp &) { return codeOf(FrameCode::GetRevUp); },
            [](const SetRevUp &) { return codeOf(FrameCode::SetRevUp); },
            [](const SetCurrentReference &) { return codeOf(FrameCode::SetCurrentReference); },
            [](const GetProfilerInfo &) { return codeOf(FrameCode::GetProfilerInfo); },
            [](const SetTorqueRamp &) { return codeOf(FrameCode::SetTorqueRamp); },
            [](const SetPosition &) { return codeOf(FrameCode::SetPosition); },
            [](const OtherRequest &other) { return other.code; },
        },
        command);
}

Bytes payloadOf(const Command &command)
{
    ByteWriter out;
    std::visit(Overloaded{
                   [&](const SetRegister &set) { out.u8(set.id).bytes(set.value); },
                   [&](const GetRegister &get) { out.u8(get.id); },
                   [&](const Execute &execute) { out.u8(execute.command); },
                   [](const GetBoardInfo &) {},
                   [](const GetFirmwareVersion &) {},
                   [&](const SetRamp &ramp) { out.s32(ramp.speed_rpm).u16(ramp.duration_ms); },
                   [&](const GetRevUp &get) { out.u8(get.stage); },
                   [&](const SetRevUp &set) {
                       out.u8(set.stage).s32(set.values.speed_rpm);
                       out.s16(set.values.torque).u16(set.values.duration_ms);
                   },
                   [&](const SetCurrentReference &set) { out.s16(set.iq).s16(set.id); },
                   [&](const GetProfilerInfo &get) { out.bytes(get.steps); },
                   [&](const SetTorqueRamp &ramp) { out.s32(ramp.torque).u16(ramp.duration_ms); },
                   [&](const SetPosition &set) { out.f32(set.angle_rad).f32(set.duration_s); },
                   [&](const OtherRequest &other) { out.bytes(other.payload); },
               },
        command);
    return out.take();
}

bool isRegisterWidth(std::size_t width) { return width == 1 || width == 2 || width == 4; }

Bytes rest(ByteReader &in)
{
    const ByteView part = in.take(in.left());
    return {part.begin(), part.end()};
}

/// The command of a payload whose length has been looked at. What is in braces is read in its order.
Command read(std::uint8_t code, ByteView payload)
{
    ByteReader in(payload);
    switch (static_cast<FrameCode>(code)) {
    case FrameCode::SetRegister:
        return SetRegister{in.u8(), rest(in)};
    case FrameCode::GetRegister:
        return GetRegister{in.u8()};
    case FrameCode::Execute:
        return Execute{in.u8()};
    case FrameCode::GetBoardInfo:
        return GetBoardInfo{};
    case FrameCode::SetRamp:
        return SetRamp{in.s32(), in.u16()};
    case FrameCode::GetRevUp:
        return GetRevUp{in.u8()};
    case FrameCode::SetRevUp:
        return SetRevUp{in.u8(), {in.s32(), in.s16(), in.u16()}};
    case FrameCode::SetCurrentReference:
        return SetCurrentReference{in.s16(), in.s16()};
    case FrameCode::GetProfilerInfo:
        return GetProfilerInfo{rest(in)};
    case FrameCode::GetFirmwareVersion:
        return GetFirmwareVersion{};
    case FrameCode::SetTorqueRamp:
        return SetTorqueRamp{in.s32(), in.u16()};
    case FrameCode::SetPosition:
        return SetPosition{in.f32(), in.f32()};
    }
    return OtherRequest{code, rest(in)};
}

} // namespace

std::optional<std::size_t> payloadSizeOf(std::uint8_t code)
{
    switch (static_cast<FrameCode>(code)) {
    case FrameCode::GetBoardInfo:
    case FrameCode::GetFirmwareVersion:
        return 0;
    case FrameCode::GetRegister:
    case FrameCode::Execute:
    case FrameCode::GetRevUp:
        return 1;
    case FrameCode::SetCurrentReference:
        return 4;
    case FrameCode::SetRamp:
    case FrameCode::SetTorqueRamp:
        return 6;
    case FrameCode::SetPosition:
        return 8;
    case FrameCode::SetRevUp:
        return 9;
    case FrameCode::SetRegister:
    case FrameCode::GetProfilerInfo:
        break;
    }
    return std::nullopt;
}

Result<Bytes, RequestError> encodeRequest(const Request &request)
{
    const std::uint8_t code = frameCodeOf(request.command);
    if (request.motor > kMostMotors || code > 0x1F)
        return fail(RequestError::BadMotor);
    const auto header = static_cast<std::uint8_t>(request.motor << 5 | code);
    if (header == kAckHeader || header == kNackHeader || header == kStartNoticeHeader)
        return fail(RequestError::IsAReply);
    if (const auto *set = std::get_if<SetRegister>(&request.command);
        set != nullptr && !isRegisterWidth(set->value.size()))
        return fail(RequestError::BadWidth);
    const Bytes payload = payloadOf(request.command);
    if (payload.size() > kMaxPayload)
        return fail(RequestError::TooLong);
    return encodeFrame(header, payload);
}

Result<Request, RequestError> decodeRequest(const Frame &frame)
{
    if (frame.header == kAckHeader || frame.header == kNackHeader
        || frame.header == kStartNoticeHeader)
        return fail(RequestError::IsAReply);
    const auto code = static_cast<std::uint8_t>(frame.header & 0x1FU);
    const std::size_t size = frame.payload.size();
    if (size > kMaxPayload)
        return fail(RequestError::TooLong);
    if (const auto wanted = payloadSizeOf(code); wanted && *wanted != size)
        return fail(size < *wanted ? RequestError::TooShort : RequestError::TooLong);
    if (code == codeOf(FrameCode::SetRegister)) {
        if (size < 2)
            return fail(RequestError::TooShort);
        if (!isRegisterWidth(size - 1))
            return fail(RequestError::BadWidth);
    }
    return Request{static_cast<std::uint8_t>(frame.header >> 5), read(code, frame.payload)};
}

} // namespace fcp
