#include "drive/fcp/fcp_commands.h"

#include "drive/fcp/fcp_writes.h"
#include "drive/values.h"
#include "drive/write_check.h"

namespace drive {

namespace {

using namespace fcp::number;

fcp::CommandId commandOf(MotorAction action)
{
    switch (action) {
    case MotorAction::Start:
        return fcp::CommandId::StartMotor;
    case MotorAction::StopMotor:
        return fcp::CommandId::StopMotor;
    case MotorAction::StopRamp:
        return fcp::CommandId::StopRamp;
    case MotorAction::AcknowledgeFaults:
        break;
    }
    return fcp::CommandId::FaultAck;
}

/// At rest the references of torque and flux read as 0, whatever a start goes to.
std::string refuseTorqueStart(const FcpFacts &board)
{
    if (auto why = refuseTorqueControl(board); !why.empty())
        return why;
    return board.user.maxCurrentAmps > 0.0
        ? "in torque control this board does not tell to which current a start goes; take your own "
          "limit of current away first"
        : "";
}

} // namespace

FcpCommandTask::FcpCommandTask(WishId id, const Command &command, const FcpFacts &board)
    : WishTask(id, permissionOf(command))
    , m_board(board)
    , m_command(command)
{
}

bool FcpCommandTask::looking()
{
    if (!std::exchange(m_looked, true)) {
        std::vector<RegisterId> ids;
        const RegisterId stages = kFcpRevUp | static_cast<RegisterId>(m_command.motor);
        if (m_board.user != UserLimits{}) {
            ids.push_back(fcpId(kControlMode, m_command.motor));
            ids.push_back(fcpId(kFinalSpeed, m_command.motor));
            if (m_board.catalog->find(stages) != nullptr && !m_board.missing.contains(stages))
                ids.push_back(stages);
        }
        m_reader.start(ids);
    }
    return !m_reader.finished();
}

/// What the board was set to before, against the user's own limits.
std::string FcpCommandTask::refuseStart() const
{
    for (const Reading &reading : m_found) {
        std::string why;
        const auto number = asNumber(reading.value);
        if (const auto *raw = std::get_if<Bytes>(&reading.value)) {
            if (const auto stages = motor::revUpOfBytes(*raw))
                why = refuseStages(m_board, m_command.motor, *stages);
        } else if (number && fcpNumber(reading.id) == kControlMode) {
            if (*number != static_cast<double>(kTorqueModeNumber))
                continue;
            if (why = refuseTorqueStart(m_board); !why.empty())
                return why;
        } else if (number) {
            why = refuseSpeed(m_board, m_command.motor, *number);
        }
        if (!why.empty())
            return m_board.catalog->nameOf(reading.id) + " is " + why;
    }
    return {};
}

std::optional<fcp::Request> FcpCommandTask::nextRequest(TimePoint)
{
    if (finished() || sent())
        return std::nullopt;
    if (auto why = refuseMotor(m_board, m_command.motor); !why.empty())
        return noRequest(Outcome::Refused, std::move(why));
    if (m_command.action == MotorAction::Start) {
        if (auto why = drive::refuseStart(m_board, m_command.motor); !why.empty())
            return noRequest(Outcome::Refused, std::move(why));
        if (looking())
            return m_reader.nextRequest();
        if (m_reader.gaveUp())
            return noRequest(Outcome::NotSent, "no answer about what it would start to");
        if (auto why = refuseStart(); !why.empty())
            return noRequest(Outcome::Refused, std::move(why));
    }
    markSent();
    return fcpRequest(
        m_command.motor, fcp::Execute{static_cast<std::uint8_t>(commandOf(m_command.action))});
}

void FcpCommandTask::onResponse(const fcp::Reply &response, TimePoint now)
{
    if (!sent()) {
        for (Reading &reading : m_reader.onResponse(response, now))
            m_found.push_back(std::move(reading));
    } else if (std::holds_alternative<fcp::Ack>(response)) {
        end(Outcome::Ok);
    } else {
        end(Outcome::Refused, nackWord(response));
    }
}

void FcpCommandTask::onNoResponse(std::optional<bool> executed, TimePoint)
{
    if (sent())
        endLost(executed);
    else
        m_reader.onNoResponse();
}

FcpSetPointTask::FcpSetPointTask(WishId id, const SetPoint &wanted, const FcpFacts &board)
    : WishTask(id, Permission::Armed)
    , m_board(board)
    , m_wanted(wanted)
{
}

fcp::Command FcpSetPointTask::encode() const
{
    const auto time = static_cast<std::uint16_t>(m_wanted.duration.count());
    const auto digits = [this](double amps) { return digitsOf(m_board, m_wanted.motor, amps); };
    switch (m_wanted.feature) {
    case Feature::SpeedRamp:
        return fcp::SetRamp{static_cast<std::int32_t>(m_wanted.first), time};
    case Feature::TorqueRamp:
        return fcp::SetTorqueRamp{digits(m_wanted.first), time};
    default:
        return fcp::SetCurrentReference{digits(m_wanted.first), digits(m_wanted.second)};
    }
}

std::optional<fcp::Request> FcpSetPointTask::nextRequest(TimePoint)
{
    if (finished() || sent())
        return std::nullopt;
    if (auto why = refuseSetPoint(m_board, m_wanted); !why.empty())
        return noRequest(Outcome::Refused, std::move(why));
    markSent();
    return fcpRequest(m_wanted.motor, encode());
}

void FcpSetPointTask::onResponse(const fcp::Reply &response, TimePoint)
{
    if (std::holds_alternative<fcp::Ack>(response))
        end(Outcome::Ok);
    else
        end(Outcome::Refused, nackWord(response));
}

void FcpSetPointTask::onNoResponse(std::optional<bool> executed, TimePoint) { endLost(executed); }

} // namespace drive
