#include "drive/mcb/requests.h"

#include "base/text.h"
#include "drive/values.h"

#include <cmath>

namespace drive {
namespace {

void addFrames(Bytes &bytes, std::uint16_t address, mcb::WordView words)
{
    for (const mcb::Frame &frame : mcb::fragmentsOf(address, mcb::Command::Write, words)) {
        const Bytes one = mcb::encodeFrame(frame);
        bytes.insert(bytes.end(), one.begin(), one.end());
    }
}

} // namespace

Bytes mcbChanges(const McbRequest &request)
{
    Bytes bytes;
    if (const auto *one = std::get_if<mcb::Master::Request>(&request)) {
        if (one->command == mcb::Command::Write)
            addFrames(bytes, one->address, one->words);
    } else if (const auto *map = std::get_if<McbMap>(&request)) {
        for (const mcb::MappingStep &step : mcb::stepsOf(map->mapping, true))
            addFrames(bytes, step.address, step.words);
    } else {
        addFrames(bytes, mcb::kStateRegister, mcb::Words{mcb::kConfigState});
    }
    return bytes;
}

AnswerEnd McbProtocol::endIn(const McbAnswer &answer)
{
    return answer.ok ? AnswerEnd{} : AnswerEnd{Outcome::Refused, mcbWordOf(answer.code)};
}

std::string mcbWordOf(std::uint32_t code)
{
    if (code == kOtherValueRead)
        return "another value is read back";
    return std::string(mcb::meaningOf(code)) + " (0x" + hexDigits(code, 8) + ")";
}

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
        return fail(std::string(kDoesNotFit));
    case mcb::ValueError::WrongKind:
        return fail(std::string("is no value for this register"));
    case mcb::ValueError::WrongSize:
    case mcb::ValueError::TooShort:
        break;
    }
    return fail(std::string("the register has a type of another size"));
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
