#include "drive/mcp/vitals.h"

#include "mcp/protocol.h"

#include <algorithm>

namespace drive {

namespace {

constexpr NumberedStep kSteps[] = {{MotorState::Idle, {0}},
    // ALIGNMENT, OFFSET_CALIB, CHARGE_BOOT_CAP, ICLWAIT, OTF_DETECTION, OTF_BRAKE, a resistance estimate; START;
    // SWITCH_OVER
    {MotorState::Starting, {2, 17, 16, kInrushWait, 21, 22, 30}}, {MotorState::Starting, {4}},
    {MotorState::Starting, {19}}, {MotorState::Running, {6}}, {MotorState::Stopping, {8, 20}},
    {MotorState::FaultNow, {10}}, {MotorState::FaultOver, {11}}};

// Of the line time that the stream leaves, polling takes no more than this part: commands and keep-alive need some,
// and a line that is full to the brim makes the board drop samples.
constexpr double kSharePolling = 0.5;
constexpr std::size_t kPacketOverhead = 6; // header and status of an answer, and one to spare
// So that even on a full line values get older, but never dead.
constexpr double kLeastBytesPerSecond = 100.0;

std::string nameOf(std::int64_t state) { return catalog::valueName("STATUS", state); }

} // namespace

/// Those before the start, and those that are rare, share a step.
std::vector<StateStep> McpProtocol::stateSteps() { return namedSteps(kSteps, nameOf); }

std::vector<RegisterId> McpVitals::idsToRead()
{
    std::vector<RegisterId> ids;
    for (int motor = 1; motor <= m_board.motors; ++motor) {
        // Every board has these. If one says otherwise it is asked again each time.
        m_refused.erase(idOf(mcp::reg::kStatus, motor));
        m_refused.erase(idOf(mcp::reg::kFaultsFlags, motor));
        ids.push_back(idOf(mcp::reg::kFaultsFlags, motor));
        // Of the family, so not before that is known.
        if (const auto *speed = m_board.catalog->find("SPEED_MEAS"))
            if (const RegisterId id = m_board.catalog->withMotor(*speed, motor);
                !m_refused.contains(id))
                ids.push_back(id);
        ids.push_back(idOf(mcp::reg::kStatus, motor));
    }
    return ids;
}

std::optional<MotorStatus> McpVitals::statusOf(int motor) const
{
    const auto state = numberOf(idOf(mcp::reg::kStatus, motor));
    if (!state && !m_refused.contains(idOf(mcp::reg::kStatus, motor)))
        return std::nullopt;
    MotorStatus status =
        numberedStatus(kSteps, nameOf, state, numberOf(idOf(mcp::reg::kFaultsFlags, motor)));
    if (const auto *speed = m_board.catalog->find("SPEED_MEAS"))
        status.speedRpm = numberOf(m_board.catalog->withMotor(*speed, motor));
    status.speedMeasured = m_board.measuresSpeed(motor);
    return status;
}

void McpWatch::onResponse(const McpAnswer &answer, TimePoint now)
{
    if (std::exchange(m_counted, m_begun) != m_begun)
        m_roundBytes = 0;
    m_roundBytes += (answer ? answer->data.size() : 0) + kPacketOverhead;
    RegisterWatch::onResponse(answer, now);
}

Duration McpWatch::leastPeriod(TimePoint) const
{
    const std::size_t bytes = m_counted == m_begun ? m_roundBytes : 0;
    const double spare = m_board.streaming.linkBytesPerSecond - m_streamLoad;
    return fromSeconds(
        static_cast<double>(bytes) / std::max(spare * kSharePolling, kLeastBytesPerSecond));
}

} // namespace drive
