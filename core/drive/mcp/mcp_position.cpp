#include "drive/mcp/mcp_position.h"

#include "analysis/ramp.h"
#include "drive/mcp/mcp_limits.h"
#include "drive/mcp/mcp_values.h"
#include "mcp/protocol.h"

#include <cmath>

namespace drive {

namespace {

constexpr const char *kPosition = "CURRENT_POSITION";
constexpr double kFarthest_rad = 1e4; // a float resolves a thousandth of a radian there

} // namespace

PositionTask::PositionTask(WishId id, const PositionRamp &ramp, const McpBoard &board)
    : WishTask(id, Permission::Armed)
    , m_board(board)
    , m_ramp(ramp)
{
}

std::string PositionTask::refuse() const
{
    if (!m_board.hasMotor(m_ramp.motor))
        return "there is no motor " + std::to_string(m_ramp.motor);
    if (auto why = m_board.reasonAgainst(Feature::PositionRamp); !why.empty())
        return why;
    if (!(std::abs(m_ramp.radians) <= kFarthest_rad))
        return "an angle is at most 10000 rad";
    // Without a time the firmware follows at once, however far it is.
    if (m_ramp.duration.count() < 1 || m_ramp.duration.count() > 0xFFFF)
        return "a move lasts 1 to 65535 ms";
    return refuseSpeed(m_board, m_ramp.motor, 0.0); // a limit that is not known
}

std::string PositionTask::refuseFrom(double position_rad) const
{
    const double seconds = std::chrono::duration<double>(m_ramp.duration).count();
    const double rpm = analysis::positionPeakSpeed_rpm(m_ramp.radians - position_rad, seconds);
    const std::string why = refuseSpeed(m_board, m_ramp.motor, rpm);
    return why.empty() ? why : "the speed on the way is " + why;
}

/// Once it is known where the shaft is.
void PositionTask::judge()
{
    m_judged = true;
    if (!m_position_rad)
        return end(Outcome::NotSent, "the board does not tell where the shaft is");
    if (auto why = refuseFrom(*m_position_rad); !why.empty())
        end(Outcome::Refused, why);
}

std::optional<Bytes> PositionTask::nextRequest(TimePoint)
{
    if (finished() || sent())
        return std::nullopt;
    if (!m_asked) {
        if (auto why = refuse(); !why.empty()) {
            end(Outcome::Refused, why);
            return std::nullopt;
        }
        m_asked = true;
        m_reader.start(
            {m_board.catalog->withMotor(*m_board.catalog->find(kPosition), m_ramp.motor)}, m_board);
    }
    if (!m_reader.finished())
        return m_reader.nextRequest(m_board);
    if (!m_judged)
        judge();
    if (finished())
        return std::nullopt;
    markSent();
    const auto seconds = std::chrono::duration<float>(m_ramp.duration).count();
    return ByteWriter()
        .u16(static_cast<unsigned>(mcp::CommandId::SetRegister) << 3)
        .u16(mcp::reg::kPositionRamp.withMotor(static_cast<unsigned>(m_ramp.motor)).bits)
        .u16(8)
        .f32(static_cast<float>(m_ramp.radians))
        .f32(seconds)
        .take();
}

void PositionTask::takeResponse(ByteView response, TimePoint now)
{
    if (!sent()) {
        for (const Reading &reading : m_reader.takeResponse(response, m_board, now))
            if (const auto number = asNumber(reading.value);
                reading.status == ReadStatus::Ok && number && std::isfinite(*number))
                m_position_rad = *number;
        if (m_reader.finished())
            judge();
        return;
    }
    if (response.size() == 1 && response.front() == static_cast<std::uint8_t>(mcp::Status::Ok))
        return end(Outcome::Ok);
    if (response.empty() || response.size() > 2)
        return end(Outcome::Unknown, "an answer that fits nothing");
    end(Outcome::Refused, statusWord(response.front()));
}

void PositionTask::takeNoResponse(std::optional<bool> executed, TimePoint)
{
    if (!sent()) {
        m_reader.takeNoResponse();
        if (m_reader.finished())
            judge();
        return;
    }
    end(executed.has_value() && !*executed ? Outcome::NotSent : Outcome::Unknown, "no answer");
}

} // namespace drive
