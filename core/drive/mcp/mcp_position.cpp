#include "drive/mcp/mcp_position.h"

#include "drive/set_point_check.h"
#include "mcp/protocol.h"

#include <cmath>

namespace drive {

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

std::string PositionTask::refuse() const
{
    if (auto why = refuseMotor(m_board, m_ramp.motor); !why.empty())
        return why;
    return refusePosition(m_board, m_ramp.motor, wanted());
}

/// Once it is known where the shaft is.
void PositionTask::judge()
{
    m_judged = true;
    if (!m_position_rad)
        return end(Outcome::NotSent, "the board does not tell where the shaft is");
    if (auto why = refuseWay(m_board, m_ramp.motor, wanted(), *m_position_rad); !why.empty())
        end(Outcome::Refused, why);
}

std::optional<McpRequest> PositionTask::nextRequest(TimePoint)
{
    if (finished() || sent())
        return std::nullopt;
    if (!m_asked) {
        if (auto why = refuse(); !why.empty())
            return noRequest(Outcome::Refused, std::move(why));
        m_asked = true;
        m_reader.start(
            {m_board.catalog->withMotor(*m_board.catalog->find(kPosition), m_ramp.motor)});
    }
    if (!m_reader.finished())
        return m_reader.nextRequest();
    if (!m_judged)
        judge();
    if (finished())
        return std::nullopt;
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
