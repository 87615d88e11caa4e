#include "drive/fcp/fcp_writes.h"

#include "drive/set_point_check.h"
#include "drive/values.h"
#include "drive/write_check.h"

namespace drive {

namespace {

/// Why the register cannot be asked for; empty if it can.
std::string refuseAddress(const FcpFacts &board, RegisterId id)
{
    const auto *info = board.catalog->find(id);
    if (info == nullptr)
        return "no such register";
    if (info->perMotor && !board.hasMotor(board.catalog->motorOf(id)))
        return "no such motor";
    if (board.missing.contains(id))
        return "this motor does not have it";
    return {};
}

} // namespace

std::string refuseStages(const FcpFacts &board, int motor, const motor::RevUp &stages)
{
    const double amps = board.ampsPerDigit(motor);
    for (const motor::RevUpStage &stage : stages) {
        if (auto why = refuseWireSpeed(board, motor, stage.speed_rpm); !why.empty())
            return why;
        if (amps > 0.0)
            if (auto why = refuseCurrent(board, motor, stage.current_digits * amps); !why.empty())
                return why;
    }
    return {};
}

std::optional<ReadStatus> FcpProtocol::refuseRead(const FcpFacts &board, RegisterId id)
{
    const auto *info = board.catalog->find(id);
    const bool readable = info != nullptr && info->readable();
    return readable && refuseAddress(board, id).empty() ? std::nullopt
                                                        : std::optional(ReadStatus::NotSupported);
}

std::string FcpWriteTask::plan(const RegisterWrite &write)
{
    const RegisterId id = write.id;
    const int motor = m_board.catalog->motorOf(id);
    const double number = asNumber(write.value).value_or(0.0);
    if (auto why = refuseAddress(m_board, id); !why.empty())
        return why;
    if (auto why = refuseWrite(m_board, write, m_reach); !why.empty())
        return why;
    if (m_board.catalog->find(id)->effect == catalog::Effect::Mode)
        if (auto why = refuseControl(
                m_board, motor, controlModeOf(static_cast<std::int64_t>(number)), m_reach);
            !why.empty())
            return why;
    readBefore();
    if (isFcpRevUp(id)) {
        const auto *raw = std::get_if<Bytes>(&write.value);
        const auto stages = motor::revUpOfBytes(raw != nullptr ? *raw : Bytes());
        if (!stages || stages->size() != fcp::kRevUpStages)
            return "takes 40 bytes";
        std::uint8_t stage = 0;
        for (const auto &[speed_rpm, torque, duration_ms] : *stages)
            this->write({fcpMotor(id), fcp::SetRevUp{stage++, {speed_rpm, torque, duration_ms}}});
        return refuseStages(m_board, motor, *stages);
    }
    const fcp::Register *which = fcp::findRegister(m_board.dialect, fcpNumber(id));
    if (which == nullptr || which->writeBytes == 0)
        return "cannot be written";
    const auto bytes = fcpBytes(*which, write.value);
    if (!bytes)
        return bytes.error();
    this->write({fcpMotor(id), fcp::SetRegister{fcpNumber(id), *bytes}});
    return which->info.id == fcp::number::kFinalSpeed ? refuseWireSpeed(m_board, motor, number)
                                                      : std::string();
}

} // namespace drive
