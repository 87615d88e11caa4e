#include "mcp/request.h"

namespace mcp {
namespace {

constexpr std::size_t kWordSize = 2;

std::uint32_t word(CommandId command, unsigned motor)
{
    return static_cast<std::uint32_t>(command) << 3 | (motor & 7U);
}

} // namespace

Result<Bytes, CodecError> encodeGet(std::span<const RegisterId> ids, std::size_t room)
{
    if (ids.empty())
        return fail(CodecError::Empty);
    if (kWordSize * (ids.size() + 1) > room)
        return fail(CodecError::TooLong);
    ByteWriter writer;
    writer.u16(word(CommandId::GetRegister, 0));
    for (const RegisterId id : ids)
        writer.u16(id.bits);
    return writer.take();
}

Result<Bytes, CodecError> encodeSet(std::span<const RegisterValue> writes, std::size_t room)
{
    if (writes.empty())
        return fail(CodecError::Empty);
    ByteWriter writer;
    writer.u16(word(CommandId::SetRegister, 0));
    for (const RegisterValue &write : writes) {
        writer.u16(write.id.bits);
        if (const auto done = encodeValue(write.id, write.value, writer); !done)
            return fail(done.error());
        if (writer.size() > room)
            return fail(CodecError::TooLong);
    }
    return writer.take();
}

Result<Bytes, CodecError> encodeCommand(CommandId command, unsigned motor, ByteView content)
{
    if (motor > 7 || (motor == 0 && isMotorCommand(static_cast<std::uint16_t>(command))))
        return fail(CodecError::NoMotor);
    return ByteWriter().u16(word(command, motor)).bytes(content).take();
}

int getOrder(RegisterId id)
{
    const int type = id.type();
    return type >= 1 && type <= 3 ? 3 - type : 3 + type;
}

bool isMotorCommand(std::uint16_t commandId)
{
    return commandId >= static_cast<std::uint16_t>(CommandId::StartMotor)
        && commandId < static_cast<std::uint16_t>(CommandId::UserFirst);
}

Result<Request, CodecError> decodeRequest(ByteView payload)
{
    ByteReader reader(payload);
    const std::uint16_t bits = reader.u16();
    if (!reader.ok())
        return fail(CodecError::TooShort);
    return Request{static_cast<std::uint16_t>(bits >> 3), static_cast<std::uint8_t>(bits & 7U),
        payload.subspan(kWordSize)};
}

Result<std::vector<RegisterId>, CodecError> decodeGetList(ByteView content)
{
    if (content.size() % 2 != 0)
        return fail(CodecError::TooShort);
    std::vector<RegisterId> ids;
    ids.reserve(content.size() / 2);
    for (ByteReader reader(content); reader.left() > 0;)
        ids.push_back({reader.u16()});
    return ids;
}

SetList decodeSetList(ByteView content)
{
    SetList list;
    ByteReader reader(content);
    while (reader.left() > 0) {
        const RegisterId id{reader.u16()};
        if (!reader.ok()) {
            list.error = CodecError::TooShort;
            break;
        }
        auto value = decodeValue(id, reader);
        if (!value) {
            list.error = value.error();
            break;
        }
        list.writes.push_back({id, *std::move(value)});
    }
    return list;
}

} // namespace mcp
