#include "fcp/reply.h"

#include <algorithm>

namespace fcp {
namespace {

constexpr std::size_t kStartNoticeSize = 13;
constexpr std::size_t kVersionParts = 3;
constexpr std::string_view kVersionMark = "Ver.";

bool isPrintable(std::uint8_t byte) { return byte >= 0x20 && byte < 0x7F; }

/// Up to the first zero.
std::string textOf(ByteView bytes)
{
    std::string text;
    for (const std::uint8_t byte : bytes) {
        if (byte == 0)
            break;
        text.push_back(isPrintable(byte) || byte == '\t' ? static_cast<char>(byte) : '?');
    }
    return text;
}

/// Three bytes that are characters from 0x20 on and integers below it.
std::string versionOf(ByteView bytes)
{
    std::string version;
    for (const std::uint8_t byte : bytes) {
        if (!version.empty())
            version.push_back('.');
        if (byte < 0x20)
            version += std::to_string(byte);
        else
            version.push_back(isPrintable(byte) ? static_cast<char>(byte) : '?');
    }
    return version;
}

/// The first character of each part of "5.4.3"; a part that is not there is 0.
void putVersion(std::string_view version, ByteWriter &out)
{
    for (std::size_t part = 0; part < kVersionParts; ++part) {
        const std::size_t dot = std::min(version.find('.'), version.size());
        out.u8(dot == 0 ? std::uint8_t{'0'} : static_cast<std::uint8_t>(version.front()));
        version.remove_prefix(std::min(dot + 1, version.size()));
    }
}

/// The text, cut or filled with zeros.
void putText(std::string_view text, std::size_t size, ByteWriter &out)
{
    const std::string_view part = text.substr(0, size);
    out.text(part);
    for (std::size_t i = part.size(); i < size; ++i)
        out.u8(0);
}

} // namespace

Result<Reply, ReplyError> decodeReply(const Frame &frame)
{
    switch (frame.header) {
    case kAckHeader:
        return Ack{frame.payload};
    case kNackHeader:
        if (frame.payload.empty())
            return Nack{};
        return Nack{frame.payload.front()};
    case kStartNoticeHeader: {
        if (frame.payload.size() != kStartNoticeSize)
            return fail(ReplyError::BadLength);
        ByteReader in(frame.payload);
        return StartNotice{
            in.u32(), versionOf(in.take(kVersionParts)), in.u16(), in.u16(), in.u16()};
    }
    default:
        return fail(ReplyError::UnknownHeader);
    }
}

Bytes encodeAck(ByteView data) { return encodeFrame(kAckHeader, data); }

Bytes encodeNack(ErrorCode error)
{
    const auto code = static_cast<std::uint8_t>(error);
    return encodeFrame(kNackHeader, ByteView(&code, 1));
}

Result<BoardInfo, ReplyError> decodeBoardInfo(ByteView data)
{
    if (data.empty())
        return fail(ReplyError::BadLength);
    const std::size_t parts = data.size() < kVersionParts ? 0 : kVersionParts;
    return BoardInfo{versionOf(data.first(parts)), textOf(data.subspan(parts))};
}

Bytes encodeBoardInfo(const BoardInfo &info)
{
    ByteWriter out;
    putVersion(info.version, out);
    putText(info.name, kInfoSize - kVersionParts, out);
    return out.take();
}

Result<FirmwareVersion, ReplyError> decodeFirmwareVersion(ByteView data)
{
    if (data.size() != kInfoSize)
        return fail(ReplyError::BadLength);
    FirmwareVersion version = firmwareVersionOf(textOf(data));
    if (version.text.empty())
        return fail(ReplyError::BadText);
    return version;
}

FirmwareVersion firmwareVersionOf(std::string_view text)
{
    FirmwareVersion version;
    version.text = text;
    const std::size_t tab = text.find('\t');
    version.name = text.substr(0, tab);
    if (tab == std::string_view::npos)
        return version;
    const std::string_view rest = text.substr(tab + 1);
    if (rest.starts_with(kVersionMark))
        version.version = rest.substr(kVersionMark.size());
    return version;
}

Bytes encodeFirmwareVersion(std::string_view text)
{
    ByteWriter out;
    putText(text, kInfoSize, out);
    return out.take();
}

Result<StageFields, ReplyError> decodeRevUp(ByteView data)
{
    ByteReader in(data);
    const StageFields stage{in.s32(), in.s16(), in.u16()};
    if (!in.ok() || in.left() > 0)
        return fail(ReplyError::BadLength);
    return stage;
}

Bytes encodeRevUp(const StageFields &stage)
{
    return ByteWriter().s32(stage.speed_rpm).s16(stage.torque).u16(stage.duration_ms).take();
}

Result<Dialect, ReplyError> decodeExecuteAck(std::uint8_t command, ByteView data)
{
    if (data.empty())
        return Dialect::Stm32;
    if (data.size() > 1)
        return fail(ReplyError::BadLength);
    if (data.front() != command)
        return fail(ReplyError::OtherCommand);
    return Dialect::PowerPc;
}

} // namespace fcp
