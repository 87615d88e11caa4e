#include "drive/mcp/mcp_values.h"

#include "base/text.h"
#include "mcp/protocol.h"

namespace drive {

using catalog::ValueType;

namespace {

constexpr std::size_t kMaxRaw = 4096; // more than any request holds

} // namespace

RegisterId idOf(mcp::RegisterId id, int motor)
{
    return id.withMotor(static_cast<unsigned>(motor)).bits;
}

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

Result<mcp::Value, std::string> wireValue(const catalog::RegisterInfo &info, const Value &value)
{
    switch (info.type) {
    case ValueType::Text:
        return fail(std::string("texts cannot be written"));
    case ValueType::Raw: {
        const auto *content = std::get_if<Bytes>(&value);
        if (content == nullptr || content->size() > kMaxRaw)
            return fail(std::string("needs its bytes"));
        return mcp::Value(*content);
    }
    case ValueType::F32: {
        const auto number = asNumber(value);
        if (!number)
            return fail(std::string("not a number"));
        if (auto bits = mcp::bitsOf(*number, info.type))
            return std::move(*bits);
        return fail(std::string("not a finite number"));
    }
    default: {
        const auto number = wholeNumberFor(info.type, value);
        if (!number)
            return fail(number.error());
        if (auto bits = mcp::bitsOf(*number, info.type))
            return std::move(*bits);
        return fail(std::string("does not fit the register"));
    }
    }
}

std::string statusWord(std::uint8_t status)
{
    const std::string_view name = mcp::statusName(status);
    if (!name.empty())
        return std::string(name);
    return "status 0x" + hexDigits(status, 2);
}

McpEnd endIn(ByteView response)
{
    if (response.empty() || response.size() > 2)
        return {Outcome::Unknown, "an answer that fits nothing"};
    if (response.size() == 1 && response.front() == static_cast<std::uint8_t>(mcp::Status::Ok))
        return {Outcome::Ok, {}};
    return {Outcome::Refused, statusWord(response.front())};
}

} // namespace drive
