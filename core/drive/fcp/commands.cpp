#include "drive/fcp/commands.h"

#include "drive/start_target.h"
#include "drive/values.h"
#include "drive/write_check.h"
#include "motor/ramp.h"
#include "motor/rev_up.h"

namespace drive {

using namespace fcp::number;

std::string FcpActTask::refuse() const
{
    const auto *wanted = std::get_if<SetPoint>(&m_act);
    return wanted != nullptr ? refuseSetPoint(m_board, *wanted)
                             : refuseCommand(m_board, std::get<Command>(m_act));
}

/// Because of the user's own limits.
std::vector<RegisterId> FcpActTask::needs() const
{
    const auto *command = std::get_if<Command>(&m_act);
    if (command == nullptr || command->action != MotorAction::Start || m_board.user == UserLimits{})
        return {};
    std::vector<RegisterId> ids{fcpId(kControlMode, m_motor), fcpId(kFinalSpeed, m_motor)};
    const RegisterId stages = kFcpRevUp | static_cast<RegisterId>(m_motor);
    if (m_board.reasonWithout(stages).empty())
        ids.push_back(stages);
    return ids;
}

std::string FcpActTask::plan()
{
    if (auto why = refuseStartTarget(m_board, m_motor, m_found); !why.empty())
        return why;
    request(fcpRequest(m_motor, encode()));
    return {};
}

fcp::Command FcpActTask::encode() const
{
    if (const auto *command = std::get_if<Command>(&m_act))
        return fcp::Execute{static_cast<std::uint8_t>(commandOf<fcp::CommandId>(command->action))};
    const auto &wanted = std::get<SetPoint>(m_act);
    const auto time = static_cast<std::uint16_t>(wanted.duration.count());
    const auto digits = [this](double amps) { return digitsOf(m_board, m_motor, amps); };
    switch (wanted.feature) {
    case Feature::SpeedRamp:
        return fcp::SetRamp{static_cast<std::int32_t>(wanted.first), time};
    case Feature::TorqueRamp:
        return fcp::SetTorqueRamp{digits(wanted.first), time};
    default:
        return fcp::SetCurrentReference{digits(wanted.first), digits(wanted.second)};
    }
}

/// Speeds are kept in steps of 0.1 Hz.
bool FcpWriteTask::same(const RegisterWrite &write, const Value &read) const
{
    if (sameValue(write.value, read) || sameStages(write.value, read))
        return true;
    const auto rpm = asNumber(write.value);
    return rpm && write.id == fcpId(kFinalSpeed, m_board.catalog->motorOf(write.id))
        && sameValue(motor::quantisedSpeed_rpm(*rpm), read);
}

std::string FcpWriteTask::plan(const RegisterWrite &write)
{
    const RegisterId id = write.id;
    const int motor = m_board.catalog->motorOf(id);
    const double number = asNumber(write.value).value_or(0.0);
    if (auto why = refuseWrite(m_board, write, m_reach); !why.empty())
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
        return refuseStages(m_board, motor, *raw);
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
