#include "drive/mcp_values.h"

#include "mcp/protocol.h"
#include "mcp/value.h"

#include <cmath>
#include <limits>

namespace drive {

using catalog::ValueType;

namespace {

constexpr std::size_t kMaxRaw = 4096; // more than any request holds

struct Range {
    std::int64_t min, max;
};
Range rangeOf(ValueType type)
{
    switch (type) {
    case ValueType::U8:
        return {0, 0xFF};
    case ValueType::S8:
        return {-0x80, 0x7F};
    case ValueType::U16:
        return {0, 0xFFFF};
    case ValueType::S16:
        return {-0x8000, 0x7FFF};
    case ValueType::U32:
        return {0, 0xFFFFFFFF};
    case ValueType::S32:
        return {-0x80000000LL, 0x7FFFFFFF};
    default:
        return {0, 0};
    }
}

/// A whole number, also where it came as a floating-point one.
std::optional<std::int64_t> wholeNumber(const Value &value)
{
    if (const auto *number = std::get_if<std::int64_t>(&value))
        return *number;
    const auto *number = std::get_if<double>(&value);
    if (number == nullptr || !std::isfinite(*number) || std::abs(*number) > 9e15
        || *number != std::nearbyint(*number))
        return std::nullopt;
    return static_cast<std::int64_t>(*number);
}

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
    const auto number = wholeNumber(value);
    if (!number)
        return fail(std::string("not a whole number"));
    const Range range = rangeOf(type);
    if (*number < range.min || *number > range.max)
        return fail(
            "out of range " + std::to_string(range.min) + " to " + std::to_string(range.max));
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

std::optional<double> asNumber(const Value &value)
{
    if (const auto *whole = std::get_if<std::int64_t>(&value))
        return static_cast<double>(*whole);
    if (const auto *real = std::get_if<double>(&value))
        return *real;
    return std::nullopt;
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
