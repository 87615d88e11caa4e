#include "drive/mcp/commands.h"

#include "base/bytes.h"
#include "catalog/control_mode.h"
#include "catalog/names.h"
#include "drive/start_target.h"
#include "mcp/protocol.h"

namespace drive {

std::vector<RegisterId> McpCommandTask::needs() const
{
    std::vector<RegisterId> ids;
    if (m_command.action != MotorAction::Start || m_board.user == UserLimits{})
        return ids;
    const auto &catalog = *m_board.catalog;
    for (const catalog::RegisterInfo &info : catalog.registers())
        if (info.readable() && !info.stub
            && (info.setPoint != catalog::SetPoint::None || info.id == mcp::reg::kControlMode.bits
                || info.id == mcp::reg::kRevUpData.bits || info.name == catalog.start().ramp[0]
                || info.name == catalog.start().torqueRamp || catalog.start().isSource(info.name)))
            ids.push_back(catalog.withMotor(info, m_motor));
    return ids;
}

std::string McpCommandTask::plan()
{
    if (auto why = refuseStartTarget(m_board, m_motor, m_found); !why.empty())
        return why;
    request(McpAct{commandOf<mcp::CommandId>(m_command.action), m_motor});
    return {};
}

void McpCommandTask::conclude(const McpRequest &asked, AnswerEnd said)
{
    if (said.outcome != Outcome::Refused)
        return ActTask::conclude(asked, std::move(said));
    m_refusal = std::move(said.reason);
    m_reader.start({idOf(mcp::reg::kStatus, m_motor), idOf(mcp::reg::kFaultsFlags, m_motor)});
}

/// What explains the refusal, as far as it was told.
void McpCommandTask::onRead()
{
    if (m_refusal.empty())
        return;
    if (const auto state = numberHeld(idOf(mcp::reg::kStatus, m_motor)))
        m_refusal += " in " + catalog::valueName("STATUS", static_cast<std::int64_t>(*state));
    if (const auto flags = numberHeld(idOf(mcp::reg::kFaultsFlags, m_motor))) {
        const auto bits = static_cast<std::uint32_t>(*flags);
        for (const std::string &fault :
            catalog::faultNames(static_cast<std::uint16_t>(bits | bits >> 16)))
            m_refusal += ", " + fault;
    }
    end(Outcome::Refused, m_refusal);
}

std::string McpSetPointTask::plan()
{
    const bool speed = m_wanted.feature == Feature::SpeedRamp;
    const std::int64_t mode = speed ? catalog::kSpeedModeNumber : catalog::kTorqueModeNumber;
    const auto now = held(needs().front());
    // A speed ramp leaves these by itself; by its number, speed control would first go to the speed of its last time,
    // at once, which brakes a motor hard that turns faster now.
    const bool leaves = speed && now
        && (*now == Value(std::int64_t{catalog::kTorqueModeNumber})
            || *now == Value(std::int64_t{catalog::kPositionModeNumber}));
    if (now && *now != Value(mode) && !leaves)
        request(mcpSet(mcp::reg::kControlMode, m_motor, static_cast<std::uint32_t>(mode)));
    const auto digits = [this](double amps) { return digitsOf(m_board, m_motor, amps); };
    const auto milliseconds = static_cast<std::uint32_t>(m_wanted.duration.count());
    ByteWriter bytes;
    switch (m_wanted.feature) {
    case Feature::SpeedRamp:
        bytes.s32(static_cast<std::int32_t>(m_wanted.first)).u16(milliseconds);
        request(mcpSet(mcp::reg::kSpeedRamp, m_motor, bytes.take()));
        break;
    case Feature::TorqueRamp:
        bytes.s32(digits(m_wanted.first)).u16(milliseconds);
        request(mcpSet(mcp::reg::kTorqueRamp, m_motor, bytes.take()));
        break;
    default:
        bytes.s16(digits(m_wanted.first)).s16(digits(m_wanted.second));
        request(mcpSet(mcp::reg::kCurrentRef, m_motor, bytes.take()));
    }
    return {};
}

std::string McpPositionTask::refuse() const
{
    auto why = refuseMotor(m_board, m_motor);
    return why.empty() ? refusePosition(m_board, m_motor, m_wanted) : why;
}

std::vector<RegisterId> McpPositionTask::needs() const
{
    return {m_board.catalog->withMotor(*m_board.catalog->find(kPosition), m_motor)};
}

std::string McpPositionTask::plan()
{
    const auto position_rad = numberHeld(needs().front());
    if (!position_rad) {
        end(Outcome::NotSent, unread());
        return {};
    }
    request(mcpSet(mcp::reg::kPositionRamp, m_motor,
        ByteWriter()
            .f32(static_cast<float>(m_wanted.radians))
            .f32(static_cast<float>(m_wanted.seconds))
            .take()));
    return refuseWay(m_board, m_motor, m_wanted, *position_rad);
}

} // namespace drive
