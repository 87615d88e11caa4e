#include "drive/mcp/mcp_vitals.h"

#include "catalog/names.h"
#include "drive/mcp/mcp_values.h"
#include "mcp/protocol.h"

#include <algorithm>

namespace drive {

namespace {

constexpr std::int64_t kInrushWait = 12;

RegisterId idOf(mcp::RegisterId id, int motor)
{
    return id.withMotor(static_cast<unsigned>(motor)).bits;
}

const Value *find(const std::map<RegisterId, Value> &values, RegisterId id)
{
    const auto at = values.find(id);
    return at == values.end() ? nullptr : &at->second;
}

} // namespace

MotorState motorStateOf(std::int64_t status)
{
    switch (status) {
    case 0:
        return MotorState::Idle;
    case 6:
        return MotorState::Running;
    case 8:
    case 20:
        return MotorState::Stopping;
    case 10:
        return MotorState::FaultNow;
    case 11:
        return MotorState::FaultOver;
    case 2: // ALIGNMENT
    case 4: // START
    case 12: // ICLWAIT
    case 16: // CHARGE_BOOT_CAP
    case 17: // OFFSET_CALIB
    case 19: // SWITCH_OVER
    case 21: // OTF_DETECTION
    case 22: // OTF_BRAKE
    case 30: // resistance estimate
        return MotorState::Starting;
    default:
        return MotorState::Unknown;
    }
}

std::vector<StateStep> stateSteps()
{
    std::vector<StateStep> steps;
    for (const std::initializer_list<std::int64_t> numbers :
        {std::initializer_list<std::int64_t>{0}, {2, 17, 16, 12, 21, 22, 30}, {4}, {19}, {6},
            {8, 20}, {10}, {11}}) {
        steps.push_back({motorStateOf(*numbers.begin()), {}});
        for (const std::int64_t number : numbers)
            steps.back().names.push_back(catalog::valueName("STATUS", number));
    }
    return steps;
}

void VitalPoll::restart(TimePoint now)
{
    m_reader.clear();
    m_round.clear();
    m_missing.clear();
    m_states.clear();
    m_news.clear();
    m_due = now;
    m_fastUntil = now;
    m_complete = false;
}

void VitalPoll::hurry(TimePoint now)
{
    m_fastUntil = now + kHurry;
    if (m_due)
        m_due = now;
}

std::vector<RegisterId> VitalPoll::idsToRead() const
{
    std::vector<RegisterId> ids;
    const auto add = [&](RegisterId id) {
        if (!m_missing.contains(id))
            ids.push_back(id);
    };
    for (int motor = 1; motor <= m_board.motors; ++motor) {
        add(idOf(mcp::reg::kFaultsFlags, motor));
        // Which register holds the speed depends on the family, so not before that is known.
        if (const auto *speed = m_board.catalog->find("SPEED_MEAS"))
            add(m_board.catalog->withMotor(*speed, motor));
        add(idOf(mcp::reg::kStatus, motor));
    }
    return ids;
}

std::optional<McpRequest> VitalPoll::nextRequest(TimePoint now)
{
    if (m_reader.finished()) {
        if (!m_due || now < *m_due)
            return std::nullopt;
        m_round.clear();
        // Every board has these. If one says otherwise it is asked again each time.
        for (int motor = 1; motor <= m_board.motors; ++motor) {
            m_missing.erase(idOf(mcp::reg::kStatus, motor));
            m_missing.erase(idOf(mcp::reg::kFaultsFlags, motor));
        }
        m_reader.start(idsToRead(), m_board);
        m_roundAsked = now;
    }
    return m_reader.nextRequest(m_board);
}

void VitalPoll::takeResponse(const ByteView &response, TimePoint now)
{
    for (Reading &reading : m_reader.takeResponse(response, m_board, now)) {
        if (reading.status == ReadStatus::Ok)
            m_round[reading.id] = std::move(reading.value);
        else
            m_missing.insert(reading.id);
    }
    if (m_reader.finished())
        publish(now);
}

void VitalPoll::takeNoResponse(std::optional<bool>, TimePoint now)
{
    m_reader.takeNoResponse();
    if (m_reader.finished())
        publish(now);
}

bool VitalPoll::somethingUnderWay() const
{
    for (const auto &[motor, state] : m_states)
        if (state == MotorState::Starting || state == MotorState::Stopping)
            return true;
    return false;
}

void VitalPoll::publish(TimePoint now)
{
    m_askedAt = m_roundAsked;
    m_complete = true;
    for (int motor = 1; motor <= m_board.motors; ++motor) {
        const Value *state = find(m_round, idOf(mcp::reg::kStatus, motor));
        if (state == nullptr && !m_missing.contains(idOf(mcp::reg::kStatus, motor))) {
            m_complete = false; // never answered this time
            continue;
        }
        MotorStatus status;
        status.motor = motor;
        status.at = now;
        if (state != nullptr) {
            status.rawState = std::get<std::int64_t>(*state);
            status.state = motorStateOf(status.rawState);
            status.waitsForBus = status.rawState == kInrushWait;
            status.stateName = catalog::valueName("STATUS", status.rawState);
        }
        if (const Value *faults = find(m_round, idOf(mcp::reg::kFaultsFlags, motor))) {
            const auto bits = static_cast<std::uint32_t>(std::get<std::int64_t>(*faults));
            status.faultsNow = catalog::faultNames(static_cast<std::uint16_t>(bits >> 16));
            status.faultsPast = catalog::faultNames(static_cast<std::uint16_t>(bits));
        }
        if (const auto *speed = m_board.catalog->find("SPEED_MEAS"))
            if (const Value *value = find(m_round, m_board.catalog->withMotor(*speed, motor)))
                status.speedRpm = asNumber(*value);
        status.speedMeasured = m_board.measuresSpeed(motor);
        m_states[motor] = status.state;
        m_news.push_back(std::move(status));
    }
    const Duration period = somethingUnderWay() || now < m_fastUntil ? kFastPeriod : kPeriod;
    // On a line that is full of samples an answer takes long: half of the time is for others.
    m_due = std::max(m_roundAsked + period, now + (now - m_roundAsked));
}

} // namespace drive
