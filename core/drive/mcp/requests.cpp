#include "drive/mcp/requests.h"

#include "base/overloaded.h"
#include "base/text.h"
#include "mcp/protocol.h"
#include "mcp/structures.h"

#include <algorithm>

namespace drive {

using catalog::ValueType;

namespace {

constexpr std::size_t kMaxRaw = 4096; // more than any request holds
constexpr std::size_t kIdBytes = 2, kCommandBytes = 2, kStatusBytes = 1;

/// Whether a structure has the size that this board's has, or one that it has in a firmware we know. An answer that
/// came too late, and now stands where another one is due, is mostly found out by that.
bool sizeFits(const McpFacts &board, RegisterId id, const Value &value)
{
    const auto *raw = std::get_if<Bytes>(&value);
    if (raw == nullptr)
        return true;
    if (const auto met = board.structureSizes.find(id); met != board.structureSizes.end())
        return raw->size() == met->second;
    if (!board.knownFirmware)
        return true;
    const mcp::RegisterId which = mcp::RegisterId{static_cast<std::uint16_t>(id)}.withMotor(0);
    const auto fits = [&](mcp::RegisterId structure, auto decode) {
        return which != structure || decode(*raw).has_value();
    };
    return fits(mcp::reg::kGlobalConfig, mcp::decodeGlobalConfig)
        && fits(mcp::reg::kMotorConfig, mcp::decodeMotorConfig)
        && fits(mcp::reg::kApplicationConfig, mcp::decodeApplicationConfig)
        && fits(mcp::reg::kFocFwConfig, mcp::decodeFirmwareConfig)
        && fits(mcp::reg::kScaleConfig, mcp::decodeScaleConfig);
}

/// Up to 6.2.1 boards give the duration before the target, but take it behind.
void putInOrder(const McpFacts &board, mcp::RegisterId id, Value &value)
{
    constexpr std::uint32_t kLastSwapped = 0x060201;
    auto *raw = std::get_if<Bytes>(&value);
    if (raw != nullptr && raw->size() == 2 * sizeof(float)
        && id.withMotor(0) == mcp::reg::kPositionRamp && board.knownFirmware
        && board.version <= kLastSwapped)
        std::rotate(raw->begin(), raw->begin() + sizeof(float), raw->end());
}

} // namespace

Result<Bytes, mcp::CodecError> encode(const McpRequest &request, std::size_t room)
{
    return std::visit(Overloaded{
                          [&](const McpGet &get) { return mcp::encodeGet(get.registers, room); },
                          [&](const McpSet &set) { return mcp::encodeSet(set.writes, room); },
                          [](const McpAct &act) {
                              return mcp::encodeCommand(
                                  act.command, static_cast<unsigned>(act.motor), act.content);
                          },
                      },
        request);
}

std::size_t wireWidth(RegisterId id)
{
    return mcp::scalarWidth(static_cast<std::uint8_t>(id >> 3 & 7U));
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
        return fail(std::string(kNotFinite));
    }
    default: {
        const auto number = wholeNumberFor(info.type, value);
        if (!number)
            return fail(number.error());
        if (auto bits = mcp::bitsOf(*number, info.type))
            return std::move(*bits);
        return fail(std::string(kDoesNotFit));
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

AnswerEnd McpProtocol::endIn(const McpAnswer &answer)
{
    const auto status = answer ? mcp::statusOf(*answer) : std::nullopt;
    if (!status)
        return {Outcome::Unknown, "an answer that fits nothing"};
    if (answer->ok() && answer->data.empty())
        return {Outcome::Ok, {}};
    return {Outcome::Refused, statusWord(*status)};
}

void McpReads::begin(std::vector<RegisterId> &ids)
{
    m_doubted.reset();
    std::ranges::stable_sort(ids, [](RegisterId a, RegisterId b) {
        return mcp::getOrder({static_cast<std::uint16_t>(a)})
            < mcp::getOrder({static_cast<std::uint16_t>(b)});
    });
}

McpRequest McpReads::request(std::span<const RegisterId> ids, std::size_t &count) const
{
    McpGet request;
    std::size_t room = m_board.responseBytes - kStatusBytes;
    count = 0;
    for (const RegisterId id : ids) {
        const std::size_t width = wireWidth(id);
        const auto *info = m_board.catalog->find(id);
        // A stub answers without a value.
        const bool alone = width == 0 || (info != nullptr && info->stub);
        if (count > 0
            && (alone || width > room
                || kCommandBytes + (count + 1) * kIdBytes > m_board.requestBytes))
            break;
        request.registers.push_back({static_cast<std::uint16_t>(id)});
        room -= std::min(width, room);
        ++count;
        if (alone)
            break;
    }
    static_assert(kCommandBytes + kIdBytes <= 32, "the smallest request holds one id");
    return request;
}

std::optional<std::vector<Reading>> McpReads::readings(
    std::span<const RegisterId> ids, const McpAnswer &answer, TimePoint now)
{
    if (!answer || ids.empty())
        return std::nullopt;
    std::vector<Reading> readings;
    if (ids.size() == 1 && answer->ok() && answer->data.empty()) { // a stub without a value
        readings.push_back({ids.front(), ReadStatus::NotSupported, {}, now});
        return readings;
    }
    std::vector<mcp::RegisterId> onWire;
    onWire.reserve(ids.size());
    for (const RegisterId id : ids)
        onWire.push_back({static_cast<std::uint16_t>(id)});
    const auto told = mcp::decodeGetAnswer(onWire, *answer);
    if (!told)
        return std::nullopt;
    for (const mcp::Value &bits : told->values) {
        const RegisterId id = ids[readings.size()];
        const mcp::RegisterId which = onWire[readings.size()];
        const auto *info = m_board.catalog->find(id);
        // The catalogue's word for how it is stored, or unsigned of the width that the id itself tells.
        Value value = mcp::interpret(bits, info != nullptr ? info->type : mcp::plainType(which));
        if (!sizeFits(m_board, id, value))
            return std::nullopt;
        putInOrder(m_board, which, value);
        readings.push_back({id, ReadStatus::Ok, std::move(value), now});
    }
    if (readings.size() < ids.size()) {
        const bool unknown =
            told->status == static_cast<std::uint8_t>(mcp::Status::UnknownRegister);
        const RegisterId failed = ids[readings.size()];
        if (m_doubted == failed)
            readings.push_back(
                {failed, unknown ? ReadStatus::NotSupported : ReadStatus::Refused, {}, now});
        m_doubted = failed;
    }
    return readings;
}

} // namespace drive
