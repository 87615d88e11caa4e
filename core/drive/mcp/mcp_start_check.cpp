#include "drive/mcp/mcp_start_check.h"

#include "base/bytes.h"
#include "drive/control_mode.h"
#include "drive/mcp/mcp_limits.h"
#include "drive/set_point_check.h"
#include "drive/start_target.h"
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

void StartCheck::onResponse(const ByteView &response, TimePoint now)
{
    for (Reading &reading : m_reader.onResponse(response, now))
        m_readings.push_back(std::move(reading));
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

} // namespace drive
