#include "drive/fcp/fcp_vitals.h"

#include "catalog/names.h"
#include "drive/values.h"

#include <array>

namespace drive {

namespace {

using namespace fcp::number;

struct StateName {
    std::int64_t number;
    MotorState state;
    std::string_view name; ///< empty: the newer firmware has it, too
};
constexpr std::int64_t kInrushWait = 12;
constexpr std::array kStates{StateName{0, MotorState::Idle, ""},
    StateName{1, MotorState::Starting, "IDLE_ALIGNMENT"}, StateName{2, MotorState::Starting, ""},
    StateName{3, MotorState::Starting, "IDLE_START"}, StateName{4, MotorState::Starting, ""},
    StateName{5, MotorState::Starting, "START_RUN"}, StateName{6, MotorState::Running, ""},
    StateName{7, MotorState::Stopping, "ANY_STOP"}, StateName{8, MotorState::Stopping, ""},
    StateName{9, MotorState::Stopping, "STOP_IDLE"}, StateName{10, MotorState::FaultNow, ""},
    StateName{11, MotorState::FaultOver, ""}, StateName{kInrushWait, MotorState::Starting, ""},
    StateName{13, MotorState::Starting, "ALIGN_CHARGE_BOOT_CAP"},
    StateName{14, MotorState::Starting, "ALIGN_OFFSET_CALIB"},
    StateName{15, MotorState::Starting, "ALIGN_CLEAR"}, StateName{16, MotorState::Starting, ""},
    StateName{17, MotorState::Starting, ""}, StateName{18, MotorState::Starting, "CLEAR"},
    StateName{19, MotorState::Starting, ""}, StateName{20, MotorState::Stopping, ""}};

std::string nameOf(std::int64_t number)
{
    for (const StateName &row : kStates)
        if (row.number == number && !row.name.empty())
            return std::string(row.name);
    return catalog::valueName("STATUS", number);
}

MotorState stateOf(std::int64_t number)
{
    for (const StateName &row : kStates)
        if (row.number == number)
            return row.state;
    return MotorState::Unknown;
}

} // namespace

std::vector<StateStep> fcpStateSteps()
{
    std::vector<StateStep> steps;
    for (const std::initializer_list<std::int64_t> numbers :
        {std::initializer_list<std::int64_t>{0}, {2, 1, 3, 12, 13, 14, 15, 16, 17, 18}, {4},
            {19, 5}, {6}, {8, 7, 9, 20}, {10}, {11}}) {
        steps.push_back({stateOf(*numbers.begin()), {}});
        for (const std::int64_t number : numbers)
            steps.back().names.push_back(nameOf(number));
    }
    return steps;
}

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
    const auto number = [&](std::uint8_t which) {
        const Value *value = valueOf(fcpId(which, motor));
        return value != nullptr ? asNumber(*value) : std::nullopt;
    };
    const auto state = number(kStatus);
    if (!state)
        return std::nullopt;
    MotorStatus status;
    status.rawState = static_cast<std::int64_t>(*state);
    status.state = stateOf(status.rawState);
    status.stateName = nameOf(status.rawState);
    status.waitsForBus = status.rawState == kInrushWait;
    status.speedRpm = number(kSpeedMeas);
    status.speedMeasured = m_board.measuresSpeed(motor); // no board tells that it has a sensor
    const auto flags = static_cast<std::uint32_t>(number(kFlags).value_or(0.0));
    status.faultsNow = catalog::faultNames(static_cast<std::uint16_t>(flags >> 16));
    status.faultsPast = catalog::faultNames(static_cast<std::uint16_t>(flags));
    return status;
}

} // namespace drive
