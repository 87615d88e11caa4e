#include "drive/mcp/mcp_values.h"

#include "mcp/protocol.h"
#include "mcp/value.h"

#include <cmath>
#include <limits>

namespace drive {

using catalog::ValueType;

namespace {

constexpr std::size_t kMaxRaw = 4096; // more than any request holds

Result<Bytes, std::string> encodeFloat(const Value &value)
{
    const auto number = asNumber(value);
    if (!number)
        return fail(std::string("not a number"));
    if (!std::isfinite(*number)
        || std::abs(*number) > static_cast<double>(std::numeric_limits<float>::max()))
        return fail(std::string("not a finite number"));
    return ByteWriter().f32(static_cast<float>(*number)).take();
}

Result<Bytes, std::string> encodeInteger(ValueType type, const Value &value)
{
    const auto number = wholeNumberFor(type, value);
    if (!number)
        return fail(number.error());
    ByteWriter writer;
    const auto bits = static_cast<std::uint32_t>(*number);
    switch (catalog::widthOf(type)) {
    case 1:
        return writer.u8(bits).take();
    case 2:
        return writer.u16(bits).take();
    default:
        return writer.u32(bits).take();
    }
}

} // namespace

ValueType typeOf(const catalog::Catalog &catalog, RegisterId id)
{
    if (const auto *info = catalog.find(id))
        return info->type;
    return mcp::plainType({static_cast<std::uint16_t>(id)});
}

std::size_t wireWidth(RegisterId id)
{
    return mcp::scalarWidth(static_cast<std::uint8_t>(id >> 3 & 7U));
}

std::optional<Value> readValue(ByteReader &bytes, RegisterId id, ValueType type)
{
    const auto value = mcp::decodeValue({static_cast<std::uint16_t>(id)}, bytes);
    return value ? std::optional<Value>(mcp::interpret(*value, type)) : std::nullopt;
}

Result<Bytes, std::string> encodeValue(const catalog::RegisterInfo &info, const Value &value)
{
    switch (info.type) {
    case ValueType::Text:
        return fail(std::string("texts cannot be written"));
    case ValueType::Raw: {
        const auto *content = std::get_if<Bytes>(&value);
        if (content == nullptr || content->size() > kMaxRaw)
            return fail(std::string("needs its bytes"));
        return ByteWriter().u16(static_cast<std::uint32_t>(content->size())).bytes(*content).take();
    }
    case ValueType::F32:
        return encodeFloat(value);
    default:
        return encodeInteger(info.type, value);
    }
}

std::string statusWord(std::uint8_t status)
{
    const std::string_view name = mcp::statusName(status);
    if (!name.empty())
        return std::string(name);
    static constexpr char kDigits[] = "0123456789ABCDEF";
    return std::string("status 0x") + kDigits[status >> 4] + kDigits[status & 0xF];
}

} // namespace drive
