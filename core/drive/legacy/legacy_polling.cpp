#include "drive/legacy/legacy_polling.h"

#include "catalog/names.h"
#include "drive/values.h"

#include <algorithm>
#include <array>

namespace drive {

namespace {

constexpr std::uint8_t kFlags = 0x01, kStatus = 0x02, kSpeedMeas = 0x1E;

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

std::vector<StateStep> legacyStateSteps()
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

void LegacyVitals::restart(TimePoint now)
{
    m_reader.clear();
    m_round.clear();
    m_states.clear();
    m_driven.clear();
    m_news.clear();
    m_due = now;
    m_fastUntil = now;
}

void LegacyVitals::hurry(TimePoint now)
{
    m_fastUntil = now + kHurry;
    if (m_due)
        m_due = now;
}

std::optional<legacy::Request> LegacyVitals::nextRequest(TimePoint now)
{
    if (m_reader.finished()) {
        if (!m_due || now < *m_due)
            return std::nullopt;
        m_round.clear();
        std::vector<RegisterId> ids;
        for (int motor = 1; motor <= m_board.motors; ++motor)
            for (const std::uint8_t number : {kFlags, kSpeedMeas, kStatus})
                ids.push_back(legacyId(number, motor));
        m_reader.start(ids);
        m_roundAsked = now;
    }
    return m_reader.nextRequest(m_board);
}

void LegacyVitals::takeResponse(const legacy::Reply &response, TimePoint now)
{
    if (auto reading = m_reader.takeResponse(response, m_board, now);
        reading && reading->status == ReadStatus::Ok)
        m_round[reading->id] = std::move(reading->value);
    if (m_reader.finished())
        publish(now);
}

void LegacyVitals::takeNoResponse(std::optional<bool>, TimePoint now)
{
    m_reader.takeNoResponse();
    if (m_reader.finished())
        publish(now);
}

void LegacyVitals::publish(TimePoint now)
{
    m_askedAt = m_roundAsked;
    const auto number = [&](std::uint8_t which, int motor) -> std::optional<double> {
        const auto at = m_round.find(legacyId(which, motor));
        return at == m_round.end() ? std::nullopt : asNumber(at->second);
    };
    bool underWay = false;
    for (int motor = 1; motor <= m_board.motors; ++motor) {
        const auto state = number(kStatus, motor);
        if (!state)
            continue; // never answered this time
        MotorStatus status;
        status.motor = motor;
        status.at = now;
        status.rawState = static_cast<std::int64_t>(*state);
        status.state = stateOf(status.rawState);
        status.stateName = nameOf(status.rawState);
        status.waitsForBus = status.rawState == kInrushWait;
        status.speedRpm = number(kSpeedMeas, motor);
        status.speedMeasured = m_board.measuresSpeed(motor); // no board tells that it has a sensor
        const auto flags = static_cast<std::uint32_t>(number(kFlags, motor).value_or(0.0));
        status.faultsNow = catalog::faultNames(static_cast<std::uint16_t>(flags >> 16));
        status.faultsPast = catalog::faultNames(static_cast<std::uint16_t>(flags));
        m_states[motor] = status.state;
        if (isDriveIdle(status))
            m_driven.erase(motor);
        else
            m_driven.insert(motor);
        m_news.push_back(std::move(status));
    }
    for (const auto &[motor, state] : m_states)
        underWay = underWay || state == MotorState::Starting || state == MotorState::Stopping;
    const Duration period = underWay || now < m_fastUntil ? kFastPeriod : kPeriod;
    // On a slow line a round takes long: half of the time is for others. One that an outage made long says nothing.
    m_due = std::max(m_roundAsked + period, now + std::min(now - m_roundAsked, kLongestPause));
}

void LegacyWatch::watch(const Watch &watch, TimePoint now)
{
    m_watch = watch;
    m_watch.period = std::max<Duration>(m_watch.period, std::chrono::milliseconds(1));
    restart(now);
}

void LegacyWatch::restart(TimePoint now)
{
    m_reader.clear();
    m_readings.clear();
    m_entries.clear();
    std::set<RegisterId> seen;
    for (const auto *list : {&m_watch.drawn, &m_watch.registers})
        for (const RegisterId id : *list)
            if (!m_board.missing.contains(id) && seen.insert(id).second)
                m_entries.push_back({id, list == &m_watch.drawn, now});
}

std::optional<TimePoint> LegacyWatch::due() const
{
    std::optional<TimePoint> first;
    for (const Entry &entry : m_entries)
        if (!first || entry.due < *first)
            first = entry.due;
    return first;
}

/// The one that waits longest; where both kinds are due they take turns, three drawn ones to one of the others.
LegacyWatch::Entry *LegacyWatch::next(TimePoint now)
{
    Entry *drawn = nullptr, *other = nullptr;
    for (Entry &entry : m_entries) {
        Entry *&best = entry.drawn ? drawn : other;
        if (entry.due <= now && (best == nullptr || entry.due < best->due))
            best = &entry;
    }
    constexpr unsigned kDrawnToOne = 3;
    if (drawn == nullptr || (other != nullptr && m_drawnInRow >= kDrawnToOne)) {
        m_drawnInRow = 0;
        return other;
    }
    ++m_drawnInRow;
    return drawn;
}

std::optional<legacy::Request> LegacyWatch::nextRequest(TimePoint now)
{
    if (m_reader.finished()) {
        Entry *entry = next(now);
        if (entry == nullptr)
            return std::nullopt;
        entry->due = entry->drawn ? now : now + m_watch.period;
        m_reader.start({entry->id});
    }
    m_asked = now;
    return m_reader.nextRequest(m_board);
}

void LegacyWatch::takeResponse(const legacy::Reply &response, TimePoint now)
{
    auto reading = m_reader.takeResponse(response, m_board, now);
    if (!reading)
        return;
    // The board looked at the value somewhere between the question and the answer.
    reading->spread = now - m_asked;
    if (reading->status != ReadStatus::Ok)
        std::erase_if(m_entries, [&](const Entry &entry) { return entry.id == reading->id; });
    m_readings.push_back(std::move(*reading));
}

void LegacyWatch::takeNoResponse(std::optional<bool>, TimePoint) { m_reader.takeNoResponse(); }

} // namespace drive
