#include "drive/legacy/legacy_reads.h"

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

std::optional<std::string> LegacyProtocol::refusalIn(const legacy::Reply &reply)
{
    return std::holds_alternative<legacy::Ack>(reply) ? std::nullopt
                                                      : std::optional(nackWord(reply));
}

legacy::Request LegacyReads::request(std::span<const RegisterId> ids, std::size_t &count) const
{
    const RegisterId id = ids.front();
    count = 1;
    if (isLegacyRevUp(id))
        return {legacyMotor(id),
            legacy::GetRevUp{static_cast<std::uint8_t>(m_stages.size() / kStageBytes)}};
    return {legacyMotor(id), legacy::GetRegister{legacyNumber(id)}};
}

std::optional<std::vector<Reading>> LegacyReads::readings(
    std::span<const RegisterId> ids, const legacy::Reply &answer, TimePoint now)
{
    Reading reading{ids.front(), ReadStatus::Ok, {}, now};
    if (const auto *ack = std::get_if<legacy::Ack>(&answer); ack == nullptr) {
        reading.status =
            nackCode(answer) == kNotThere ? ReadStatus::NotSupported : ReadStatus::Refused;
    } else if (isLegacyRevUp(reading.id)) {
        m_stages.insert(m_stages.end(), ack->data.begin(), ack->data.end());
        if (m_stages.size() < kStageBytes * legacy::kRevUpStages)
            return std::vector<Reading>();
        reading.value = m_stages;
    } else {
        const auto *which = legacy::findRegister(m_board.dialect, legacyNumber(reading.id));
        auto value = which != nullptr ? legacyValue(*which, ack->data) : std::nullopt;
        reading.status = value ? ReadStatus::Ok : ReadStatus::NotSupported;
        reading.value = std::move(value).value_or(Value());
    }
    drop();
    return std::vector{std::move(reading)};
}

} // namespace drive
