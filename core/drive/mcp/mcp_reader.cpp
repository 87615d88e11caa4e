#include "drive/mcp/mcp_reader.h"

#include "drive/mcp/mcp_values.h"
#include "mcp/protocol.h"
#include "mcp/structures.h"

#include <algorithm>

namespace drive {

namespace {

constexpr std::size_t kIdBytes = 2, kCommandBytes = 2, kStatusBytes = 1;

/// Whether a structure has a size that this register has in a firmware we know. An answer that came too late, and now
/// stands where another one is due, is mostly found out by that.
bool sizeFits(RegisterId id, const Value &value)
{
    const auto *raw = std::get_if<Bytes>(&value);
    if (raw == nullptr)
        return true;
    const mcp::RegisterId which = mcp::RegisterId{static_cast<std::uint16_t>(id)}.withMotor(0);
    if (which == mcp::reg::kGlobalConfig)
        return mcp::decodeGlobalConfig(*raw).has_value();
    if (which == mcp::reg::kMotorConfig)
        return mcp::decodeMotorConfig(*raw).has_value();
    if (which == mcp::reg::kApplicationConfig)
        return mcp::decodeApplicationConfig(*raw).has_value();
    if (which == mcp::reg::kFocFwConfig)
        return mcp::decodeFirmwareConfig(*raw).has_value();
    if (which == mcp::reg::kScaleConfig)
        return mcp::decodeScaleConfig(*raw).has_value();
    return true;
}

} // namespace

void RegisterReader::start(const std::vector<RegisterId> &ids)
{
    clear();
    m_waiting.assign(ids.begin(), ids.end());
    std::stable_sort(m_waiting.begin(), m_waiting.end(), [](RegisterId a, RegisterId b) {
        return mcp::getOrder({static_cast<std::uint16_t>(a)})
            < mcp::getOrder({static_cast<std::uint16_t>(b)});
    });
}

void RegisterReader::clear()
{
    m_waiting.clear();
    m_batch = 0;
    m_losses = 0;
    m_gaveUp = false;
    m_doubted.reset();
}

std::optional<McpRequest> RegisterReader::nextRequest()
{
    if (m_waiting.empty())
        return std::nullopt;
    McpGet request;
    std::size_t room = m_board.responseBytes - kStatusBytes;
    m_batch = 0;
    for (const RegisterId id : m_waiting) {
        const std::size_t width = wireWidth(id);
        const auto *info = m_board.catalog->find(id);
        const bool alone =
            width == 0 || (info != nullptr && info->stub); // a stub answers without a value
        if (m_batch > 0
            && (alone || width > room
                || kCommandBytes + (m_batch + 1) * kIdBytes > m_board.requestBytes))
            break;
        request.registers.push_back({static_cast<std::uint16_t>(id)});
        room -= std::min(width, room);
        ++m_batch;
        if (alone)
            break;
    }
    static_assert(kCommandBytes + kIdBytes <= 32, "the smallest request holds one id");
    return request;
}

std::vector<Reading> RegisterReader::takeResponse(const ByteView &response, TimePoint now)
{
    std::vector<Reading> readings;
    if (response.empty() || m_batch == 0) {
        takeNoResponse();
        return readings;
    }
    const std::uint8_t status = response.back();
    ByteReader values(response.first(response.size() - kStatusBytes));
    while (readings.size() < m_batch && values.left() > 0) {
        const RegisterId id = m_waiting[readings.size()];
        auto value = readValue(values, id, typeOf(*m_board.catalog, id));
        if (!value)
            break;
        if (m_board.knownFirmware && !sizeFits(id, *value)) {
            takeNoResponse();
            return {};
        }
        readings.push_back({id, ReadStatus::Ok, std::move(*value), now});
    }
    const bool ok = status == static_cast<std::uint8_t>(mcp::Status::Ok);
    const bool silent =
        ok && m_batch == 1 && response.size() == kStatusBytes; // a stub without a value
    const bool complete = values.ok() && values.left() == 0;
    if (!complete || (ok ? readings.size() != m_batch && !silent : readings.size() == m_batch)) {
        takeNoResponse();
        return {};
    }
    if (readings.size() < m_batch) {
        const bool unknown =
            silent || status == static_cast<std::uint8_t>(mcp::Status::UnknownRegister);
        const RegisterId failed = m_waiting[readings.size()];
        if (silent || m_doubted == failed)
            readings.push_back(
                {failed, unknown ? ReadStatus::NotSupported : ReadStatus::Refused, {}, now});
        m_doubted = failed;
    }
    const std::size_t done = readings.size();
    m_waiting.erase(m_waiting.begin(), m_waiting.begin() + static_cast<std::ptrdiff_t>(done));
    m_batch = 0;
    m_losses = 0;
    return readings;
}

void RegisterReader::takeNoResponse()
{
    if (++m_losses <= kRepeats || m_waiting.empty())
        return;
    m_gaveUp = true;
    m_waiting.erase(m_waiting.begin(), m_waiting.begin() + static_cast<std::ptrdiff_t>(m_batch));
    m_batch = 0;
    m_losses = 0;
}

} // namespace drive
