#include "drive/mcp/mcp_reads.h"

#include "drive/mcp/mcp_values.h"
#include "mcp/protocol.h"
#include "mcp/structures.h"

#include <algorithm>

namespace drive {

namespace {

constexpr std::size_t kIdBytes = 2, kCommandBytes = 2, kStatusBytes = 1;

/// Whether a structure has the size that this board's has, or one that it has in a firmware we know. An answer that came
/// too late, and now stands where another one is due, is mostly found out by that.
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

} // namespace

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
        const bool alone =
            width == 0 || (info != nullptr && info->stub); // a stub answers without a value
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
    std::span<const RegisterId> ids, ByteView answer, TimePoint now)
{
    std::vector<Reading> readings;
    if (answer.empty() || ids.empty())
        return std::nullopt;
    const std::uint8_t status = answer.back();
    ByteReader values(answer.first(answer.size() - kStatusBytes));
    while (readings.size() < ids.size() && values.left() > 0) {
        const RegisterId id = ids[readings.size()];
        auto value = readValue(values, id, typeOf(*m_board.catalog, id));
        if (!value)
            break;
        if (!sizeFits(m_board, id, *value))
            return std::nullopt;
        readings.push_back({id, ReadStatus::Ok, std::move(*value), now});
    }
    const bool ok = status == static_cast<std::uint8_t>(mcp::Status::Ok);
    const bool silent =
        ok && ids.size() == 1 && answer.size() == kStatusBytes; // a stub without a value
    const bool all = readings.size() == ids.size();
    if (!values.ok() || values.left() > 0 || (ok ? !all && !silent : all))
        return std::nullopt;
    if (!all) {
        const bool unknown =
            silent || status == static_cast<std::uint8_t>(mcp::Status::UnknownRegister);
        const RegisterId failed = ids[readings.size()];
        if (silent || m_doubted == failed)
            readings.push_back(
                {failed, unknown ? ReadStatus::NotSupported : ReadStatus::Refused, {}, now});
        m_doubted = failed;
    }
    return readings;
}

} // namespace drive
