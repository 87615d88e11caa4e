#include "drive/fcp/fcp_commands.h"

#include "drive/values.h"
#include "drive/write_check.h"
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

/// What the board was set to before, against the user's own limits.
std::string FcpActTask::plan()
{
    for (const Reading &reading : m_found) {
        std::string why;
        const auto number = asNumber(reading.value);
        if (const auto *raw = std::get_if<Bytes>(&reading.value)) {
            why = refuseStages(m_board, m_motor, *raw);
        } else if (number && fcpNumber(reading.id) == kControlMode) {
            if (*number != static_cast<double>(catalog::kTorqueModeNumber))
                continue;
            if (why = refuseTorqueControl(m_board); !why.empty())
                return why;
            // At rest the references of torque and flux read as 0, whatever a start goes to.
            if (m_board.user.maxCurrentAmps > 0.0)
                return "in torque control this board does not tell to which current a start goes; "
                       "take your own limit of current away first";
        } else if (number) {
            why = refuseSpeed(m_board, m_motor, *number);
        }
        if (!why.empty())
            return m_board.catalog->nameOf(reading.id) + " is " + why;
    }
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
