#include "drive/mcb/mcb_reads.h"

#include "drive/mcb/mcb_catalog.h"
#include "drive/mcb/mcb_messages.h"

#include <cmath>

namespace drive {

std::optional<Value> mcbValueOf(const McbFacts &board, std::uint16_t address, mcb::WordView words)
{
    const mcb::Info *info = board.infoOf(address);
    if (info == nullptr)
        return std::nullopt;
    auto value = mcb::decodeValue(*info, words, board.order);
    return value ? std::optional(std::move(*value)) : std::nullopt;
}

Result<mcb::Words, std::string> mcbWordsOf(
    const McbFacts &board, std::uint16_t address, const Value &value)
{
    const mcb::Info *info = board.infoOf(address);
    if (info == nullptr)
        return fail(std::string("no such register"));
    Value wanted = value;
    // A whole number may come as a floating-point one.
    if (const auto *real = std::get_if<double>(&value); real != nullptr && info->type
        && *info->type != mcb::Type::Float && *info->type != mcb::Type::Text
        && *real == std::nearbyint(*real) && std::abs(*real) < 9e15)
        wanted = static_cast<std::int64_t>(*real);
    auto words = mcb::encodeValue(*info, wanted, board.order);
    if (words)
        return std::move(*words);
    switch (words.error()) {
    case mcb::ValueError::OutOfRange:
        return fail(std::string("does not fit the register"));
    case mcb::ValueError::WrongKind:
        return fail(std::string("is no value for this register"));
    case mcb::ValueError::WrongSize:
    case mcb::ValueError::TooShort:
        break;
    }
    return fail(std::string("the register has a type of another size"));
}

std::optional<ReadStatus> McbProtocol::refuseRead(const McbFacts &board, RegisterId id)
{
    const std::uint16_t address = mcbAddressOf(id);
    return board.infoOf(address) == nullptr || board.readable(address)
        ? std::nullopt
        : std::optional(ReadStatus::NotSupported);
}

McbRequest McbReads::request(std::span<const RegisterId> ids, std::size_t &count) const
{
    count = 1;
    return mcbRead(mcbAddressOf(ids.front()));
}

std::optional<std::vector<Reading>> McbReads::readings(
    std::span<const RegisterId> ids, const McbAnswer &answer, TimePoint now) const
{
    Reading reading{ids.front(), ReadStatus::Refused, {}, now};
    auto value = answer.ok ? mcbValueOf(m_board, mcbAddressOf(reading.id), answer.words)
                           : std::optional<Value>();
    if (value) {
        reading.status = ReadStatus::Ok;
        reading.value = std::move(*value);
    } else if (!answer.ok
        && answer.code == static_cast<std::uint32_t>(mcb::ErrorCode::NoSuchRegister)) {
        reading.status = ReadStatus::NotSupported;
    }
    return std::vector{std::move(reading)};
}

} // namespace drive
