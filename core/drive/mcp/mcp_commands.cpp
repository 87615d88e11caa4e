#include "drive/mcp/mcp_commands.h"

#include "catalog/names.h"
#include "drive/control_mode.h"
#include "drive/mcp/mcp_values.h"
#include "drive/set_point_check.h"
#include "drive/write_check.h"
#include "mcp/protocol.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drive {

namespace {

mcp::CommandId commandOf(MotorAction action)
{
    switch (action) {
    case MotorAction::Start:
        return mcp::CommandId::StartMotor;
    case MotorAction::StopMotor:
        return mcp::CommandId::StopMotor;
    case MotorAction::StopRamp:
        return mcp::CommandId::StopRamp;
    case MotorAction::AcknowledgeFaults:
        break;
    }
    return mcp::CommandId::FaultAck;
}

RegisterId idOf(mcp::RegisterId id, int motor)
{
    return id.withMotor(static_cast<unsigned>(motor)).bits;
}

bool isOk(ByteView response)
{
    return response.size() == 1 && response.front() == static_cast<std::uint8_t>(mcp::Status::Ok);
}

/// The word for a refusal; empty if the answer is none that fits a command.
std::string refusalIn(ByteView response)
{
    return response.empty() || response.size() > 2 ? std::string() : statusWord(response.front());
}

} // namespace

CommandTask::CommandTask(WishId id, const Command &command, const McpBoard &board)
    : WishTask(
        id, command.action == MotorAction::StopMotor ? Permission::Always : Permission::Armed)
    , m_board(board)
    , m_command(command)
    , m_check(board, command.motor)
{
}

/// Whether a start has still to be looked into; ends the wish if it must not be.
bool CommandTask::checking(std::optional<McpRequest> &request)
{
    if (auto why = refuseStart(m_board, m_command.motor); !why.empty()) {
        end(Outcome::Refused, std::move(why));
        return false;
    }
    request = m_check.nextRequest();
    if (request)
        return true;
    if (m_check.gaveUp())
        end(Outcome::NotSent, "no answer about what it would start to");
    else if (auto why = m_check.refusal(); !why.empty())
        end(Outcome::Refused, std::move(why));
    return false;
}

std::optional<McpRequest> CommandTask::nextRequest(TimePoint)
{
    if (!m_refusal.empty())
        return m_reader.nextRequest();
    if (finished() || sent())
        return std::nullopt;
    if (auto why = refuseMotor(m_board, m_command.motor); !why.empty()) {
        end(Outcome::Refused, std::move(why));
        return std::nullopt;
    }
    if (std::optional<McpRequest> question;
        m_command.action == MotorAction::Start && (checking(question) || finished()))
        return question;
    markSent();
    return McpAct{commandOf(m_command.action), m_command.motor};
}

void CommandTask::takeResponse(const ByteView &response, TimePoint now)
{
    if (!sent())
        return m_check.takeResponse(response, now);
    if (!m_refusal.empty()) {
        for (const Reading &reading : m_reader.takeResponse(response, now)) {
            const auto *value = std::get_if<std::int64_t>(&reading.value);
            if (reading.status != ReadStatus::Ok || value == nullptr)
                continue;
            if (reading.id == idOf(mcp::reg::kStatus, m_command.motor)) {
                m_state = " in " + catalog::valueName("STATUS", *value);
            } else {
                const auto bits = static_cast<std::uint32_t>(*value);
                for (const std::string &fault :
                    catalog::faultNames(static_cast<std::uint16_t>(bits | bits >> 16)))
                    m_faults += ", " + fault;
            }
        }
        if (m_reader.finished())
            end(Outcome::Refused, m_refusal + m_state + m_faults);
        return;
    }
    if (isOk(response))
        return end(Outcome::Ok);
    if (refusalIn(response).empty())
        return end(Outcome::Unknown, "an answer that fits nothing");
    m_refusal = refusalIn(response);
    m_reader.start(
        {idOf(mcp::reg::kStatus, m_command.motor), idOf(mcp::reg::kFaultsFlags, m_command.motor)});
}

void CommandTask::takeNoResponse(std::optional<bool> executed, TimePoint)
{
    if (!sent())
        return m_check.takeNoResponse();
    if (!m_refusal.empty()) {
        m_reader.takeNoResponse();
        if (m_reader.finished())
            end(Outcome::Refused, m_refusal + m_state + m_faults);
        return;
    }
    endLost(executed);
}

SetPointTask::SetPointTask(WishId id, const SpeedRamp &ramp, const McpBoard &board)
    : WishTask(id, Permission::Armed)
    , m_board(board)
    , m_kind(Kind::Speed)
    , m_motor(ramp.motor)
    , m_first(ramp.rpm)
    , m_duration(ramp.duration)
{
}

SetPointTask::SetPointTask(WishId id, const TorqueRamp &ramp, const McpBoard &board)
    : WishTask(id, Permission::Armed)
    , m_board(board)
    , m_kind(Kind::Torque)
    , m_motor(ramp.motor)
    , m_first(ramp.amps)
    , m_duration(ramp.duration)
{
}

SetPointTask::SetPointTask(WishId id, const CurrentReference &reference, const McpBoard &board)
    : WishTask(id, Permission::Armed)
    , m_board(board)
    , m_kind(Kind::Current)
    , m_motor(reference.motor)
    , m_first(reference.iqAmps)
    , m_second(reference.idAmps)
{
}

std::string SetPointTask::refuse() const
{
    if (auto why = refuseMotor(m_board, m_motor); !why.empty())
        return why;
    const Feature feature = m_kind == Kind::Speed ? Feature::SpeedRamp
        : m_kind == Kind::Torque                  ? Feature::TorqueRamp
                                                  : Feature::CurrentReference;
    if (auto why = m_board.reasonAgainst(feature); !why.empty())
        return why;
    if (auto why = refuseRampTime(m_duration); !why.empty())
        return why;
    if (m_kind == Kind::Speed)
        return refuseWireSpeed(m_board, m_motor, m_first);
    if (!(m_board.ampsPerDigit(m_motor) > 0.0))
        return "the current scale of motor " + std::to_string(m_motor) + " is not known";
    if (auto why = refuseCurrent(m_board, m_motor, std::hypot(m_first, m_second)); !why.empty())
        return why;
    constexpr std::int32_t kGreatest = std::numeric_limits<std::int16_t>::max();
    return std::max(std::abs(digits(m_first)), std::abs(digits(m_second))) > kGreatest
        ? "beyond what 16 bits hold"
        : "";
}

std::uint32_t SetPointTask::milliseconds() const
{
    return static_cast<std::uint32_t>(m_duration.count());
}

std::int32_t SetPointTask::digits(double amps) const
{
    constexpr double kOut = 32768.0; // of 16 bits; refused
    return static_cast<std::int32_t>(
        std::clamp(std::nearbyint(amps / m_board.ampsPerDigit(m_motor)), -kOut, kOut));
}

Bytes SetPointTask::encode() const
{
    switch (m_kind) {
    case Kind::Speed:
        return ByteWriter().s32(static_cast<std::int32_t>(m_first)).u16(milliseconds()).take();
    case Kind::Torque:
        return ByteWriter().s32(digits(m_first)).u16(milliseconds()).take();
    case Kind::Current:
        break;
    }
    return ByteWriter().s16(digits(m_first)).s16(digits(m_second)).take();
}

std::optional<McpRequest> SetPointTask::nextRequest(TimePoint)
{
    if (finished())
        return std::nullopt;
    const std::int64_t mode = m_kind == Kind::Speed ? kSpeedModeNumber : kTorqueModeNumber;
    switch (m_step) {
    case Step::Begin:
        if (auto why = refuse(); !why.empty()) {
            end(Outcome::Refused, why);
            return std::nullopt;
        }
        m_step = Step::ReadMode;
        m_reader.start({idOf(mcp::reg::kControlMode, m_motor)});
        [[fallthrough]];
    case Step::ReadMode:
        return m_reader.nextRequest();
    case Step::SetMode:
        markSent();
        return mcpSet(mcp::reg::kControlMode, m_motor, static_cast<std::uint32_t>(mode));
    case Step::SetPoint:
        break;
    }
    const mcp::RegisterId target = m_kind == Kind::Speed ? mcp::reg::kSpeedRamp
        : m_kind == Kind::Torque                         ? mcp::reg::kTorqueRamp
                                                         : mcp::reg::kCurrentRef;
    markSent();
    return mcpSet(target, m_motor, encode());
}

void SetPointTask::takeResponse(const ByteView &response, TimePoint now)
{
    if (m_step == Step::ReadMode) {
        const std::int64_t wanted = m_kind == Kind::Speed ? kSpeedModeNumber : kTorqueModeNumber;
        bool already = false;
        for (const Reading &reading : m_reader.takeResponse(response, now))
            already = reading.status != ReadStatus::Ok || reading.value == Value(wanted);
        if (m_reader.finished())
            m_step = already && !m_reader.gaveUp() ? Step::SetPoint : Step::SetMode;
        return;
    }
    if (!isOk(response)) {
        const std::string word = refusalIn(response);
        return word.empty() ? end(Outcome::Unknown, "an answer that fits nothing")
                            : end(Outcome::Refused, word);
    }
    if (m_step == Step::SetMode)
        m_step = Step::SetPoint;
    else
        end(Outcome::Ok);
}

void SetPointTask::takeNoResponse(std::optional<bool> executed, TimePoint)
{
    if (m_step == Step::ReadMode) {
        m_reader.takeNoResponse();
        if (m_reader.finished())
            end(Outcome::NotSent, "no answer");
        return;
    }
    if (m_step == Step::SetMode && executed == false && !std::exchange(m_modeRepeated, true))
        return; // a scalar that was not written may be written again
    endLost(executed);
}

} // namespace drive
