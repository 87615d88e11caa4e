#include "drive/mcp/mcp_commands.h"

#include "base/bytes.h"
#include "catalog/names.h"
#include "drive/control_mode.h"
#include "drive/start_target.h"
#include "drive/write_check.h"
#include "mcp/protocol.h"

#include <cmath>

namespace drive {

namespace {

/// Where it is not 0 the motor follows what is no set-point: an open loop, a potentiometer.
bool isSource(const catalog::RegisterInfo &info)
{
    return info.name == "OPENLOOP" || info.name == "FOC_SPEED_SOURCE_SELECT";
}

constexpr std::string_view kSpeedRamp = "SPEED_RAMP", kTorqueRamp = "TORQUE_RAMP";

} // namespace

std::vector<RegisterId> StartCheck::wanted() const
{
    std::vector<RegisterId> ids;
    if (m_board.user == UserLimits{})
        return ids;
    const auto &catalog = *m_board.catalog;
    for (const catalog::RegisterInfo &info : catalog.registers())
        if (info.readable() && !info.stub
            && (info.setPoint != catalog::SetPoint::None || info.id == mcp::reg::kControlMode.bits
                || info.id == mcp::reg::kRevUpData.bits || info.name == kSpeedRamp
                || info.name == kTorqueRamp || isSource(info)))
            ids.push_back(catalog.withMotor(info, m_motor));
    return ids;
}

std::optional<McpRequest> StartCheck::nextRequest()
{
    if (!std::exchange(m_started, true))
        m_reader.start(wanted());
    return m_reader.nextRequest();
}

std::optional<Value> StartCheck::held(RegisterId id) const
{
    for (const Reading &reading : m_readings)
        if (reading.id == id && reading.status == ReadStatus::Ok)
            return reading.value;
    return std::nullopt;
}

std::string StartCheck::refusal() const
{
    std::optional<std::int64_t> mode;
    for (const Reading &reading : m_readings)
        if (const auto *number = std::get_if<std::int64_t>(&reading.value);
            number != nullptr && (reading.id & ~RegisterId{7}) == mcp::reg::kControlMode.bits)
            mode = *number;
    const bool torque = mode == kTorqueModeNumber;
    if (torque)
        if (auto why = refuseTorqueControl(m_board); !why.empty())
            return why;
    if (mode && *mode != kPositionModeNumber && controlModeOf(*mode) == ControlMode::Other)
        return "in this control mode no limit of your own holds: take yours away first";
    const StartTarget target = startTarget(*m_board.catalog, m_board.limitsOf(m_motor), m_motor,
        [this](RegisterId id) { return held(id); });
    const bool byRamp = target.ramp.has_value(); // the reference is left from before, then
    for (const Reading &reading : m_readings) {
        const auto *info = m_board.catalog->find(reading.id);
        if (reading.status != ReadStatus::Ok || info == nullptr)
            continue;
        if (isSource(*info) && asNumber(reading.value).value_or(0.0) != 0.0)
            return info->name + " is on, and then no limit of your own holds: turn it off first";
        std::string why;
        if (info->name == kSpeedRamp)
            why = byRamp ? refuseSpeed(m_board, m_motor, target.rpm.value_or(0.0)) : "";
        else if (info->name == kTorqueRamp)
            why = torque ? refuseTorque(reading.value) : "";
        else if (const auto *raw = std::get_if<Bytes>(&reading.value))
            why = refuseStages(m_board, m_motor, *raw);
        else if (torque || (info->setPoint == catalog::SetPoint::Speed && !byRamp))
            why = refuseNumber(m_board, {reading.id, reading.value});
        if (!why.empty())
            return info->name + " is " + why;
    }
    return {};
}

/// Of the last torque ramp: firmware keeps 16 bits, which come first in either length that it is read with.
std::string StartCheck::refuseTorque(const Value &held) const
{
    const auto *bytes = std::get_if<Bytes>(&held);
    if (bytes == nullptr || bytes->size() < sizeof(std::int16_t))
        return {};
    const double digits = ByteReader(*bytes).s16();
    return refuseCurrent(m_board, m_motor, digits * m_board.ampsPerDigit(m_motor));
}

CommandTask::CommandTask(WishId id, const Command &command, const McpFacts &board)
    : WishTask(id, permissionOf(command))
    , m_board(board)
    , m_command(command)
    , m_check(board, command.motor)
{
}

std::optional<McpRequest> CommandTask::nextRequest(TimePoint)
{
    if (!m_refusal.empty())
        return m_reader.nextRequest();
    if (finished() || sent())
        return std::nullopt;
    if (auto why = refuseMotor(m_board, m_command.motor); !why.empty())
        return noRequest(Outcome::Refused, std::move(why));
    if (m_command.action == MotorAction::Start) {
        if (auto why = refuseStart(m_board, m_command.motor); !why.empty())
            return noRequest(Outcome::Refused, std::move(why));
        if (auto question = m_check.nextRequest())
            return question;
        if (m_check.gaveUp())
            return noRequest(Outcome::NotSent, "no answer about what it would start to");
        if (auto why = m_check.refusal(); !why.empty())
            return noRequest(Outcome::Refused, std::move(why));
    }
    markSent();
    return McpAct{commandOf<mcp::CommandId>(m_command.action), m_command.motor};
}

void CommandTask::onResponse(const ByteView &response, TimePoint now)
{
    if (!sent())
        return m_check.onResponse(response, now);
    if (!m_refusal.empty()) {
        for (const Reading &reading : m_reader.onResponse(response, now)) {
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
    const McpEnd said = endIn(response);
    if (said.outcome != Outcome::Refused)
        return end(said.outcome, said.reason);
    m_refusal = said.reason;
    m_reader.start(
        {idOf(mcp::reg::kStatus, m_command.motor), idOf(mcp::reg::kFaultsFlags, m_command.motor)});
}

void CommandTask::onNoResponse(std::optional<bool> executed, TimePoint)
{
    if (!sent())
        return m_check.onNoResponse();
    if (!m_refusal.empty()) {
        m_reader.onNoResponse();
        if (m_reader.finished())
            end(Outcome::Refused, m_refusal + m_state + m_faults);
        return;
    }
    endLost(executed);
}

SetPointTask::SetPointTask(WishId id, const SetPoint &wanted, const McpFacts &board)
    : WishTask(id, Permission::Armed)
    , m_board(board)
    , m_wanted(wanted)
    , m_mode(wanted.feature == Feature::SpeedRamp ? kSpeedModeNumber : kTorqueModeNumber)
{
}

McpRequest SetPointTask::order() const
{
    const auto digits = [this](double amps) { return digitsOf(m_board, m_wanted.motor, amps); };
    const auto milliseconds = static_cast<std::uint32_t>(m_wanted.duration.count());
    ByteWriter bytes;
    switch (m_wanted.feature) {
    case Feature::SpeedRamp:
        bytes.s32(static_cast<std::int32_t>(m_wanted.first)).u16(milliseconds);
        return mcpSet(mcp::reg::kSpeedRamp, m_wanted.motor, bytes.take());
    case Feature::TorqueRamp:
        bytes.s32(digits(m_wanted.first)).u16(milliseconds);
        return mcpSet(mcp::reg::kTorqueRamp, m_wanted.motor, bytes.take());
    default:
        bytes.s16(digits(m_wanted.first)).s16(digits(m_wanted.second));
        return mcpSet(mcp::reg::kCurrentRef, m_wanted.motor, bytes.take());
    }
}

std::optional<McpRequest> SetPointTask::nextRequest(TimePoint)
{
    if (finished())
        return std::nullopt;
    switch (m_step) {
    case Step::Begin:
        if (auto why = refuseSetPoint(m_board, m_wanted); !why.empty())
            return noRequest(Outcome::Refused, std::move(why));
        m_step = Step::ReadMode;
        m_reader.start({idOf(mcp::reg::kControlMode, m_wanted.motor)});
        [[fallthrough]];
    case Step::ReadMode:
        return m_reader.nextRequest();
    case Step::SetMode:
        markSent();
        return mcpSet(mcp::reg::kControlMode, m_wanted.motor, static_cast<std::uint32_t>(m_mode));
    case Step::SetPoint:
        break;
    }
    markSent();
    return order();
}

void SetPointTask::onResponse(const ByteView &response, TimePoint now)
{
    if (m_step == Step::ReadMode) {
        bool already = false;
        for (const Reading &reading : m_reader.onResponse(response, now))
            already = reading.status != ReadStatus::Ok || reading.value == Value(m_mode);
        if (m_reader.finished())
            m_step = already && !m_reader.gaveUp() ? Step::SetPoint : Step::SetMode;
        return;
    }
    const McpEnd said = endIn(response);
    if (m_step == Step::SetMode && said.outcome == Outcome::Ok)
        m_step = Step::SetPoint;
    else
        end(said.outcome, said.reason);
}

void SetPointTask::onNoResponse(std::optional<bool> executed, TimePoint)
{
    if (m_step == Step::ReadMode) {
        m_reader.onNoResponse();
        if (m_reader.finished())
            end(Outcome::NotSent, "no answer");
        return;
    }
    if (m_step == Step::SetMode && executed == false && !std::exchange(m_modeRepeated, true))
        return; // a scalar that was not written may be written again
    endLost(executed);
}

PositionTask::PositionTask(WishId id, const PositionRamp &ramp, const McpFacts &board)
    : WishTask(id, Permission::Armed)
    , m_board(board)
    , m_ramp(ramp)
{
}

RawPosition PositionTask::wanted() const
{
    return {m_ramp.radians, std::chrono::duration<double>(m_ramp.duration).count()};
}

/// Once it is known where the shaft is.
void PositionTask::judge()
{
    if (!m_position_rad)
        return end(Outcome::NotSent, "the board does not tell where the shaft is");
    if (auto why = refuseWay(m_board, m_ramp.motor, wanted(), *m_position_rad); !why.empty())
        end(Outcome::Refused, why);
}

std::optional<McpRequest> PositionTask::nextRequest(TimePoint)
{
    if (finished() || sent())
        return std::nullopt;
    if (!std::exchange(m_asked, true)) {
        auto why = refuseMotor(m_board, m_ramp.motor);
        if (why.empty())
            why = refusePosition(m_board, m_ramp.motor, wanted());
        if (!why.empty())
            return noRequest(Outcome::Refused, std::move(why));
        m_reader.start(
            {m_board.catalog->withMotor(*m_board.catalog->find(kPosition), m_ramp.motor)});
    }
    if (!m_reader.finished())
        return m_reader.nextRequest();
    markSent();
    const auto seconds = std::chrono::duration<float>(m_ramp.duration).count();
    return mcpSet(mcp::reg::kPositionRamp, m_ramp.motor,
        ByteWriter().f32(static_cast<float>(m_ramp.radians)).f32(seconds).take());
}

void PositionTask::onResponse(const ByteView &response, TimePoint now)
{
    if (!sent()) {
        for (const Reading &reading : m_reader.onResponse(response, now))
            if (const auto number = asNumber(reading.value);
                reading.status == ReadStatus::Ok && number && std::isfinite(*number))
                m_position_rad = *number;
        if (m_reader.finished())
            judge();
        return;
    }
    const McpEnd said = endIn(response);
    end(said.outcome, said.reason);
}

void PositionTask::onNoResponse(std::optional<bool> executed, TimePoint)
{
    if (!sent()) {
        m_reader.onNoResponse();
        if (m_reader.finished())
            judge();
        return;
    }
    endLost(executed);
}

} // namespace drive
