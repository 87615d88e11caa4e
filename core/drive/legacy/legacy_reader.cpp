#include "drive/legacy/legacy_reader.h"

namespace drive {

namespace {

constexpr std::size_t kStageBytes = 8;
constexpr auto kNotThere = static_cast<std::uint8_t>(legacy::ErrorCode::WriteOnly);

} // namespace

std::optional<std::uint8_t> nackCode(const legacy::Reply &reply)
{
    const auto *nack = std::get_if<legacy::Nack>(&reply);
    return nack != nullptr ? nack->error : std::nullopt;
}

std::string nackWord(const legacy::Reply &reply)
{
    if (!std::holds_alternative<legacy::Nack>(reply))
        return {};
    const auto code = nackCode(reply);
    if (!code)
        return "refused without a reason";
    if (const auto name = legacy::errorName(*code); !name.empty())
        return std::string(name);
    static constexpr char kDigits[] = "0123456789ABCDEF";
    return std::string("unknown error 0x") + kDigits[*code >> 4] + kDigits[*code & 0xF];
}

void LegacyReader::start(const std::vector<RegisterId> &ids)
{
    m_waiting.assign(ids.begin(), ids.end());
    m_stages.clear();
    m_losses = 0;
    m_gaveUp = false;
}

std::optional<legacy::Request> LegacyReader::nextRequest() const
{
    if (m_waiting.empty())
        return std::nullopt;
    const RegisterId id = m_waiting.front();
    legacy::Request request{legacyMotor(id), legacy::GetRegister{legacyNumber(id)}};
    if (isLegacyRevUp(id))
        request.command =
            legacy::GetRevUp{static_cast<std::uint8_t>(m_stages.size() / kStageBytes)};
    return request;
}

std::vector<Reading> LegacyReader::done(ReadStatus status, Value value, TimePoint now)
{
    Reading reading{m_waiting.front(), status, std::move(value), now};
    m_waiting.pop_front();
    m_stages.clear();
    m_losses = 0;
    return {std::move(reading)};
}

std::vector<Reading> LegacyReader::takeResponse(const legacy::Reply &response, TimePoint now)
{
    if (m_waiting.empty())
        return {};
    const RegisterId id = m_waiting.front();
    const auto *ack = std::get_if<legacy::Ack>(&response);
    if (ack == nullptr)
        return done(
            nackCode(response) == kNotThere ? ReadStatus::NotSupported : ReadStatus::Refused, {},
            now);
    if (isLegacyRevUp(id)) {
        m_losses = 0;
        m_stages.insert(m_stages.end(), ack->data.begin(), ack->data.end());
        if (m_stages.size() < kStageBytes * legacy::kRevUpStages)
            return {};
        return done(ReadStatus::Ok, std::exchange(m_stages, {}), now);
    }
    const legacy::Register *which = legacy::findRegister(m_board.dialect, legacyNumber(id));
    auto value = which != nullptr ? legacyValue(*which, ack->data) : std::nullopt;
    return value ? done(ReadStatus::Ok, std::move(*value), now)
                 : done(ReadStatus::NotSupported, {}, now);
}

void LegacyReader::takeNoResponse()
{
    if (m_waiting.empty() || ++m_losses < kRepeats)
        return;
    m_waiting.pop_front();
    m_stages.clear();
    m_losses = 0;
    m_gaveUp = true;
}

} // namespace drive
