#include "mcb/value.h"

#include "catalog/limits.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace mcb {
namespace {

using catalog::Access;

constexpr unsigned kReadOnly = 3, kWriteOnly = 5, kReadWrite = 7;
constexpr unsigned kTypeMask = 0x3F, kUnknownType = 0x3F;

constexpr unsigned codeOf(Access access)
{
    switch (access) {
    case Access::Read:
        return kReadOnly;
    case Access::Write:
        return kWriteOnly;
    case Access::ReadWrite:
        return kReadWrite;
    case Access::None:
        break;
    }
    return 0;
}

constexpr Access accessOf(unsigned code)
{
    for (const Access access : {Access::Read, Access::Write, Access::ReadWrite})
        if (codeOf(access) == code)
            return access;
    return Access::None;
}

std::uint8_t byteOf(std::uint16_t word, bool upper)
{
    return static_cast<std::uint8_t>(upper ? word >> 8 : word);
}

std::string textOf(WordView words, std::size_t bytes, TextOrder order)
{
    std::string text;
    for (std::size_t i = 0; i < bytes; ++i) {
        const bool upper = (i % 2 == 0) == (order == TextOrder::HighByteFirst);
        const auto c = static_cast<char>(byteOf(words[i / 2], upper));
        if (c == '\0')
            break;
        text.push_back(c);
    }
    return text;
}

Words wordsOfText(const std::string &text, std::size_t bytes, TextOrder order)
{
    Words words(wordsOf(bytes));
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool upper = (i % 2 == 0) == (order == TextOrder::HighByteFirst);
        const unsigned code = static_cast<unsigned char>(text[i]);
        words[i / 2] = static_cast<std::uint16_t>(words[i / 2] | (upper ? code << 8 : code));
    }
    return words;
}

Result<Words, ValueError> encodeFloat(const catalog::Value &value)
{
    double number = 0.0;
    if (const auto *real = std::get_if<double>(&value))
        number = *real;
    else if (const auto *whole = std::get_if<std::int64_t>(&value))
        number = static_cast<double>(*whole);
    else
        return fail(ValueError::WrongKind);
    if (!(std::abs(number) <= double{std::numeric_limits<float>::max()}))
        return fail(ValueError::OutOfRange);
    return wordsOfNumber(std::bit_cast<std::uint32_t>(static_cast<float>(number)), 4);
}

Result<Words, ValueError> encodeWhole(const Info &info, const catalog::Value &value)
{
    const auto *number = std::get_if<std::int64_t>(&value);
    if (number == nullptr)
        return fail(ValueError::WrongKind);
    if (!catalog::typeLimits(valueTypeOf(info)).holds(static_cast<double>(*number)))
        return fail(ValueError::OutOfRange);
    return wordsOfNumber(static_cast<std::uint64_t>(*number), info.size);
}

Result<Words, ValueError> encodeText(
    std::size_t bytes, const catalog::Value &value, TextOrder order)
{
    const auto *text = std::get_if<std::string>(&value);
    if (text == nullptr)
        return fail(ValueError::WrongKind);
    if (text->size() > bytes)
        return fail(ValueError::OutOfRange);
    return wordsOfText(*text, bytes, order);
}

Result<Words, ValueError> encodeRaw(std::size_t bytes, const catalog::Value &value)
{
    const auto *raw = std::get_if<Bytes>(&value);
    if (raw == nullptr)
        return fail(ValueError::WrongKind);
    if (raw->size() != 2 * wordsOf(bytes))
        return fail(ValueError::OutOfRange);
    Words words;
    for (std::size_t i = 0; i < raw->size(); i += 2)
        words.push_back(static_cast<std::uint16_t>((*raw)[i] << 8 | (*raw)[i + 1]));
    return words;
}

std::int64_t signedOf(Type type, std::uint64_t bits)
{
    switch (type) {
    case Type::Int16:
        return static_cast<std::int16_t>(bits);
    case Type::Int32:
        return static_cast<std::int32_t>(bits);
    default:
        return static_cast<std::int64_t>(bits);
    }
}

} // namespace

Info infoOf(const ConfigWords &config)
{
    Info info;
    info.size = static_cast<std::uint8_t>(config[0]);
    const unsigned type = config[0] >> 8 & kTypeMask;
    if (type <= static_cast<unsigned>(Type::Text))
        info.type = static_cast<Type>(type);
    info.cyclic = static_cast<Cyclic>(config[0] >> 14);
    info.access = accessOf(config[1] & 7U);
    return info;
}

ConfigWords configOf(const Info &info)
{
    const unsigned type = info.type ? static_cast<unsigned>(*info.type) : kUnknownType;
    const unsigned cyclic = static_cast<unsigned>(info.cyclic);
    return {static_cast<std::uint16_t>(info.size | type << 8 | cyclic << 14),
        static_cast<std::uint16_t>(codeOf(info.access)), 0, 0};
}

catalog::ValueType valueTypeOf(const Info &info)
{
    using enum catalog::ValueType;
    constexpr std::array kTypes{S16, U16, S32, U32, F32, Text};
    return info.type ? kTypes[static_cast<std::size_t>(*info.type)] : Raw;
}

Words wordsOfNumber(std::uint64_t number, std::size_t bytes)
{
    Words words;
    for (std::size_t i = 0; i < bytes && i < 8; i += 2) {
        const unsigned word = (number >> (8 * i)) & 0xFFFF;
        words.push_back(static_cast<std::uint16_t>(i + 1 == bytes ? word & 0xFF : word));
    }
    return words;
}

std::optional<std::uint64_t> numberOf(WordView words, std::size_t bytes)
{
    if (bytes > 8 || words.size() < wordsOf(bytes))
        return std::nullopt;
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < bytes; ++i)
        number |= std::uint64_t{byteOf(words[i / 2], i % 2 != 0)} << (8 * i);
    return number;
}

Result<catalog::Value, ValueError> decodeValue(const Info &info, WordView words, TextOrder order)
{
    if (words.size() < wordsOf(info.size))
        return fail(ValueError::TooShort);
    if (!info.type) {
        Bytes raw;
        for (const std::uint16_t word : words.first(wordsOf(info.size))) {
            raw.push_back(byteOf(word, true));
            raw.push_back(byteOf(word, false));
        }
        return raw;
    }
    if (*info.type == Type::Text)
        return textOf(words, info.size, order);
    if (info.size != catalog::widthOf(valueTypeOf(info)))
        return fail(ValueError::WrongSize);
    const std::uint64_t bits = *numberOf(words, info.size);
    if (*info.type == Type::Float)
        return double{std::bit_cast<float>(static_cast<std::uint32_t>(bits))};
    return signedOf(*info.type, bits);
}

Result<Words, ValueError> encodeValue(
    const Info &info, const catalog::Value &value, TextOrder order)
{
    if (!info.type)
        return encodeRaw(info.size, value);
    if (*info.type == Type::Text)
        return encodeText(info.size, value, order);
    if (info.size != catalog::widthOf(valueTypeOf(info)))
        return fail(ValueError::WrongSize);
    return *info.type == Type::Float ? encodeFloat(value) : encodeWhole(info, value);
}

} // namespace mcb
