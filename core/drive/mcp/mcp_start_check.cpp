#include "drive/mcp/mcp_start_check.h"

#include "drive/control_mode.h"
#include "drive/mcp/mcp_limits.h"
#include "mcp/protocol.h"
#include "mcp/structures.h"

namespace drive {

std::vector<RegisterId> StartCheck::wanted() const
{
    std::vector<RegisterId> ids;
    if (m_board.user == UserLimits{})
        return ids;
    const auto &catalog = *m_board.catalog;
    for (const catalog::RegisterInfo &info : catalog.registers())
        if (info.readable() && !info.stub
            && (info.setPoint != catalog::SetPoint::None || info.id == mcp::reg::kControlMode.bits
                || info.id == mcp::reg::kRevupData.bits))
            ids.push_back(catalog.withMotor(info, m_motor));
    return ids;
}

std::optional<Bytes> StartCheck::nextRequest()
{
    if (!std::exchange(m_started, true))
        m_reader.start(wanted(), m_board);
    return m_reader.nextRequest(m_board);
}

void StartCheck::takeResponse(ByteView response, TimePoint now)
{
    for (Reading &reading : m_reader.takeResponse(response, m_board, now))
        m_readings.push_back(std::move(reading));
}

void StartCheck::takeNoResponse() { m_reader.takeNoResponse(); }

std::string StartCheck::refuseStages(ByteView raw) const
{
    const auto stages = mcp::decodeRevUpData(raw);
    const double amps = m_board.ampsPerDigit(m_motor); // 0: six-step, whose stages hold no current
    if (!stages)
        return {};
    for (const mcp::RevUpStage &stage : *stages) {
        if (auto why = refuseSpeed(m_board, m_motor, stage.rpm); !why.empty())
            return why;
        if (amps > 0.0)
            if (auto why = refuseCurrent(m_board, m_motor, stage.digits * amps); !why.empty())
                return why;
    }
    return {};
}

std::string StartCheck::refusal() const
{
    bool torque = false;
    for (const Reading &reading : m_readings)
        torque = torque
            || ((reading.id & ~RegisterId{7}) == mcp::reg::kControlMode.bits
                && reading.value == Value(kTorqueModeNumber));
    for (const Reading &reading : m_readings) {
        const auto *info = m_board.catalog->find(reading.id);
        if (reading.status != ReadStatus::Ok || info == nullptr)
            continue;
        std::string why;
        if (const auto *raw = std::get_if<Bytes>(&reading.value))
            why = refuseStages(*raw);
        else if (info->setPoint == catalog::SetPoint::Speed || torque)
            why = refuseSetPoint(m_board, {reading.id, reading.value});
        if (!why.empty())
            return info->name + " is " + why;
    }
    return {};
}

} // namespace drive
