#include "drive/mcp/mcp_start_check.h"

#include "drive/control_mode.h"
#include "drive/mcp/mcp_limits.h"
#include "drive/set_point_check.h"
#include "drive/values.h"
#include "drive/write_check.h"
#include "mcp/protocol.h"

namespace drive {

namespace {

/// Where it is not 0 the motor follows what is no set-point: an open loop, a potentiometer.
bool isSource(const catalog::RegisterInfo &info)
{
    return info.name == "OPENLOOP" || info.name == "FOC_SPEED_SOURCE_SELECT";
}

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
                || info.id == mcp::reg::kRevUpData.bits || isSource(info)))
            ids.push_back(catalog.withMotor(info, m_motor));
    return ids;
}

std::optional<McpRequest> StartCheck::nextRequest()
{
    if (!std::exchange(m_started, true))
        m_reader.start(wanted());
    return m_reader.nextRequest();
}

void StartCheck::onResponse(const ByteView &response, TimePoint now)
{
    for (Reading &reading : m_reader.onResponse(response, now))
        m_readings.push_back(std::move(reading));
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
        return "in this control mode no limit of your own holds; take yours away first";
    for (const Reading &reading : m_readings) {
        const auto *info = m_board.catalog->find(reading.id);
        if (reading.status != ReadStatus::Ok || info == nullptr)
            continue;
        if (isSource(*info) && asNumber(reading.value).value_or(0.0) != 0.0)
            return info->name + " is on, and then no limit of your own holds; turn it off first";
        std::string why;
        if (const auto *raw = std::get_if<Bytes>(&reading.value))
            why = refuseStages(m_board, m_motor, *raw);
        else if (info->setPoint == catalog::SetPoint::Speed || torque)
            why = refuseNumber(m_board, {reading.id, reading.value});
        if (!why.empty())
            return info->name + " is " + why;
    }
    return {};
}

} // namespace drive
