#include "drive/fcp/requests.h"

#include "base/text.h"

namespace drive {

std::optional<std::uint8_t> nackCode(const fcp::Reply &reply)
{
    const auto *nack = std::get_if<fcp::Nack>(&reply);
    return nack != nullptr ? nack->error : std::nullopt;
}

AnswerEnd FcpProtocol::endIn(const fcp::Reply &reply)
{
    if (std::holds_alternative<fcp::Ack>(reply))
        return {};
    const auto code = nackCode(reply);
    if (!code)
        return {Outcome::Refused, "refused without a reason"};
    const std::string name(fcp::errorName(*code));
    return {Outcome::Refused, name.empty() ? "unknown error 0x" + hexDigits(*code, 2) : name};
}

std::optional<ReadStatus> FcpReads::refuse(const FcpFacts &board, RegisterId id)
{
    const auto *info = board.catalog->find(id);
    return board.reasonWithout(id).empty() && info->readable()
        ? std::nullopt
        : std::optional(ReadStatus::NotSupported);
}

fcp::Request FcpReads::request(std::span<const RegisterId> ids, std::size_t &count) const
{
    const RegisterId id = ids.front();
    count = 1;
    if (isFcpRevUp(id))
        return {fcpMotor(id),
            fcp::GetRevUp{static_cast<std::uint8_t>(m_stages.size() / fcp::kStageBytes)}};
    return {fcpMotor(id), fcp::GetRegister{fcpNumber(id)}};
}

std::optional<std::vector<Reading>> FcpReads::readings(
    std::span<const RegisterId> ids, const fcp::Reply &answer, TimePoint now)
{
    constexpr auto kNotThere = static_cast<std::uint8_t>(fcp::ErrorCode::WriteOnly);
    Reading reading{ids.front(), ReadStatus::Ok, {}, now};
    if (const auto *ack = std::get_if<fcp::Ack>(&answer); ack == nullptr) {
        reading.status =
            nackCode(answer) == kNotThere ? ReadStatus::NotSupported : ReadStatus::Refused;
    } else if (isFcpRevUp(reading.id)) {
        m_stages.insert(m_stages.end(), ack->data.begin(), ack->data.end());
        if (m_stages.size() < fcp::kStageBytes * fcp::kRevUpStages)
            return std::vector<Reading>();
        reading.value = m_stages;
    } else {
        const auto *which = fcp::findRegister(m_board.dialect, fcpNumber(reading.id));
        auto value = which != nullptr ? fcpValue(*which, ack->data) : std::nullopt;
        reading.status = value ? ReadStatus::Ok : ReadStatus::NotSupported;
        reading.value = std::move(value).value_or(Value());
    }
    drop();
    return std::vector{std::move(reading)};
}

} // namespace drive
