#include "mcp/value.h"

#include "catalog/limits.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace mcp {
namespace {

using catalog::ValueType;

std::uint32_t maskOf(std::size_t width)
{
    return width >= 4 ? 0xFFFFFFFFU : (1U << (8 * width)) - 1;
}

Result<Value, CodecError> integerBits(std::int64_t number, ValueType type)
{
    if (!catalog::typeLimits(type).holds(static_cast<double>(number)))
        return fail(CodecError::OutOfRange);
    return Value{static_cast<std::uint32_t>(number) & maskOf(catalog::widthOf(type))};
}

Result<Value, CodecError> realBits(double number, ValueType type)
{
    if (!std::isfinite(number))
        return fail(CodecError::OutOfRange);
    if (type == ValueType::F32) {
        if (std::abs(number) > static_cast<double>(std::numeric_limits<float>::max()))
            return fail(CodecError::OutOfRange);
        return Value{std::bit_cast<std::uint32_t>(static_cast<float>(number))};
    }
    constexpr double kSafe = 1e10; // beyond every integer format, well within 64 bits
    if (std::abs(number) > kSafe || number != std::trunc(number))
        return fail(CodecError::OutOfRange);
    return integerBits(static_cast<std::int64_t>(number), type);
}

} // namespace

Result<Value, CodecError> decodeValue(RegisterId id, ByteReader &reader)
{
    switch (static_cast<RegisterType>(id.type())) {
    case RegisterType::Bits8:
    case RegisterType::Bits16:
    case RegisterType::Bits32: {
        const std::size_t width = scalarWidth(id.type());
        if (reader.left() < width)
            return fail(CodecError::TooShort);
        return Value{width == 1 ? reader.u8() : width == 2 ? reader.u16() : reader.u32()};
    }
    case RegisterType::String: {
        std::string text = reader.zeroTerminated();
        if (!reader.ok())
            return fail(CodecError::NoTerminator);
        return Value{std::move(text)};
    }
    case RegisterType::Raw: {
        const std::size_t size = reader.u16();
        const ByteView content = reader.take(size);
        if (!reader.ok())
            return fail(CodecError::TooShort);
        return Value{Bytes(content.begin(), content.end())};
    }
    }
    return fail(CodecError::BadType);
}

Result<void, CodecError> encodeValue(RegisterId id, const Value &value, ByteWriter &writer)
{
    if (const std::size_t width = scalarWidth(id.type())) {
        const auto *bits = std::get_if<std::uint32_t>(&value);
        if (!bits)
            return fail(CodecError::WrongKind);
        if ((*bits & ~maskOf(width)) != 0)
            return fail(CodecError::OutOfRange);
        if (width == 1)
            writer.u8(*bits);
        else if (width == 2)
            writer.u16(*bits);
        else
            writer.u32(*bits);
        return {};
    }
    if (id.type() == static_cast<std::uint8_t>(RegisterType::String)) {
        const auto *text = std::get_if<std::string>(&value);
        if (!text)
            return fail(CodecError::WrongKind);
        writer.text(text->substr(0, text->find('\0'))).u8(0);
        return {};
    }
    if (id.type() != static_cast<std::uint8_t>(RegisterType::Raw))
        return fail(CodecError::BadType);
    const auto *content = std::get_if<Bytes>(&value);
    if (!content)
        return fail(CodecError::WrongKind);
    if (content->size() > std::numeric_limits<std::uint16_t>::max())
        return fail(CodecError::TooLong);
    writer.u16(static_cast<std::uint32_t>(content->size())).bytes(*content);
    return {};
}

catalog::Value interpret(const Value &value, ValueType type)
{
    if (const auto *text = std::get_if<std::string>(&value))
        return *text;
    if (const auto *content = std::get_if<Bytes>(&value))
        return *content;
    const std::uint32_t bits = std::get<std::uint32_t>(value);
    switch (type) {
    case ValueType::S8:
        return std::int64_t{static_cast<std::int8_t>(bits)};
    case ValueType::S16:
        return std::int64_t{static_cast<std::int16_t>(bits)};
    case ValueType::S32:
        return std::int64_t{static_cast<std::int32_t>(bits)};
    case ValueType::F32:
        return static_cast<double>(std::bit_cast<float>(bits));
    default:
        return std::int64_t{bits};
    }
}

Result<Value, CodecError> bitsOf(const catalog::Value &value, ValueType type)
{
    if (const auto *text = std::get_if<std::string>(&value))
        return type == ValueType::Text ? Result<Value, CodecError>(*text)
                                       : fail(CodecError::WrongKind);
    if (const auto *content = std::get_if<Bytes>(&value))
        return type == ValueType::Raw ? Result<Value, CodecError>(*content)
                                      : fail(CodecError::WrongKind);
    if (type == ValueType::Text || type == ValueType::Raw)
        return fail(CodecError::WrongKind);
    if (const auto *number = std::get_if<double>(&value))
        return realBits(*number, type);
    const std::int64_t number = std::get<std::int64_t>(value);
    return type == ValueType::F32 ? realBits(static_cast<double>(number), type)
                                  : integerBits(number, type);
}

ValueType plainType(RegisterId id)
{
    constexpr std::array kTypes{
        ValueType::Raw, ValueType::U8, ValueType::U16, ValueType::U32, ValueType::Text};
    return id.type() < kTypes.size() ? kTypes[id.type()] : ValueType::Raw;
}

} // namespace mcp
