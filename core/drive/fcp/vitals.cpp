#include "drive/fcp/vitals.h"

#include <algorithm>

namespace drive {

namespace {

using namespace fcp::number;

constexpr NumberedStep kSteps[] = {{MotorState::Idle, {0}},
    {MotorState::Starting, {2, 1, 3, kInrushWait, 13, 14, 15, 16, 17, 18}},
    {MotorState::Starting, {4}}, {MotorState::Starting, {19, 5}}, {MotorState::Running, {6}},
    {MotorState::Stopping, {8, 7, 9, 20}}, {MotorState::FaultNow, {10}},
    {MotorState::FaultOver, {11}}};
/// Those that the newer firmware does not have.
constexpr catalog::NamedValue kOlderNames[] = {{1, "IDLE_ALIGNMENT"}, {3, "IDLE_START"},
    {5, "START_RUN"}, {7, "ANY_STOP"}, {9, "STOP_IDLE"}, {13, "ALIGN_CHARGE_BOOT_CAP"},
    {14, "ALIGN_OFFSET_CALIB"}, {15, "ALIGN_CLEAR"}, {18, "CLEAR"}};

std::string nameOf(std::int64_t number)
{
    const auto *older = std::ranges::find(kOlderNames, number, &catalog::NamedValue::value);
    return older != std::end(kOlderNames) ? std::string(older->name)
                                          : catalog::valueName("STATUS", number);
}

} // namespace

std::vector<StateStep> FcpProtocol::stateSteps() { return namedSteps(kSteps, nameOf); }

std::vector<RegisterId> FcpVitals::idsToRead()
{
    std::vector<RegisterId> ids;
    for (int motor = 1; motor <= m_board.motors; ++motor)
        for (const std::uint8_t number : {kFlags, kSpeedMeas, kStatus})
            ids.push_back(fcpId(number, motor));
    return ids;
}

std::optional<MotorStatus> FcpVitals::statusOf(int motor) const
{
    const auto number = [&](std::uint8_t which) { return numberOf(fcpId(which, motor)); };
    const auto state = number(kStatus);
    if (!state)
        return std::nullopt;
    MotorStatus status = numberedStatus(kSteps, nameOf, state, number(kFlags));
    status.speedRpm = number(kSpeedMeas);
    status.speedMeasured = m_board.measuresSpeed(motor); // no board tells that it has a sensor
    return status;
}

} // namespace drive
