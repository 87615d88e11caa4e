#include "drive/mcp/identification.h"

#include "catalog/catalog.h"
#include "drive/mcp/heartbeat.h"
#include "drive/mcp/scales.h"
#include "drive/mcp/stream.h"
#include "mcp/protocol.h"

#include <algorithm>

namespace drive {

namespace {

constexpr int kMaxMotors = 7; // what three bits can number
constexpr int kMostRounds = 8; // of reading a structure until it is there, and the same twice
constexpr std::uint32_t kOldestKnown = 0x060000, kNewestKnown = 0x0604FF;

constexpr catalog::StartRegisters kStart{{"CONTROL_MODE"}, {"SPEED_RAMP"},
    {"FOC_SPEEDREF_FREQ_PU", "SPEED_REF"}, {"FOC_IQREF", "I_Q_REF"}, catalog::controlModeOf,
    "TORQUE_RAMP", {"OPENLOOP", "FOC_SPEED_SOURCE_SELECT"}};

std::string versionText(std::uint32_t version)
{
    return std::to_string(version >> 16 & 0xFF) + "." + std::to_string(version >> 8 & 0xFF) + "."
        + std::to_string(version & 0xFF);
}

/// Whether a damaged answer would do more than look wrong: structures, and a name that promises a watchdog.
bool decidesSomething(const Reading &reading)
{
    const auto *text = std::get_if<std::string>(&reading.value);
    if (text != nullptr)
        return reading.id == mcp::reg::kFwName.bits && watchdogIn(*text);
    return std::holds_alternative<Bytes>(reading.value);
}

/// The speed of the sensor that closes the loops, where it can be streamed.
std::string speedSignalOf(const McpMotorDescription &motor, const catalog::Catalog &catalog)
{
    if (!motor.firmware || motor.firmware->sixStep)
        return {};
    const auto *sensor =
        std::ranges::find(kSensors, motor.firmware->primarySensor, &McpSensor::number);
    const auto *info = sensor == std::end(kSensors) ? nullptr : catalog.find(sensor->speed);
    return info && info->streaming != catalog::Streaming::Polled ? std::string(sensor->speed)
                                                                 : std::string();
}

} // namespace

void McpIdentification::restart()
{
    m_phase = Phase::Count;
    m_values.clear();
    m_doubtful.clear();
    m_rounds = 0;
    m_global = {};
    m_sizesKnown = true;
    m_stopLosses = 0;
    m_board.forget();
    m_board.structureSizes.clear();
    m_board.sensors.clear();
    m_board.hso = false;
    m_board.version = 0;
    m_unanswered = {mcp::reg::kGlobalConfig.bits};
    m_reader.start({mcp::reg::kGlobalConfig.bits});
}

std::optional<McpRequest> McpIdentification::nextRequest(TimePoint)
{
    if (m_phase == Phase::StopDatalog)
        return datalogRequest(m_board.linkId, mcp::datalogStop(m_board.streamBytes));
    if (m_phase == Phase::Count || m_phase == Phase::Describe)
        return m_reader.nextRequest();
    return std::nullopt;
}

void McpIdentification::onResponse(const McpAnswer &answer, TimePoint now)
{
    if (m_phase == Phase::StopDatalog)
        return describe(); // builds without a datalog refuse, which is as good as stopped
    onReadings(m_reader.onResponse(answer, now));
    if (m_reader.finished())
        afterRound();
}

void McpIdentification::onNoResponse(std::optional<bool>, TimePoint)
{
    if (m_phase == Phase::StopDatalog) {
        if (++m_stopLosses >= McpProtocol::kAttempts)
            describe();
        return;
    }
    m_reader.onNoResponse();
    if (m_reader.finished())
        afterRound();
}

void McpIdentification::onReadings(std::vector<Reading> readings)
{
    for (Reading &reading : readings) {
        m_unanswered.erase(reading.id);
        if (reading.status != ReadStatus::Ok)
            continue;
        const auto before = m_values.find(reading.id);
        const bool same = before != m_values.end() && before->second == reading.value;
        if (!same && decidesSomething(reading))
            m_doubtful.insert(reading.id);
        else
            m_doubtful.erase(reading.id);
        m_values[reading.id] = std::move(reading.value);
    }
}

void McpIdentification::afterRound()
{
    // What a busy line swallowed is no hole in the board: without its scales all would be shown in digits.
    std::set<RegisterId> again = m_doubtful;
    again.insert(m_unanswered.begin(), m_unanswered.end());
    if (!again.empty() && ++m_rounds < kMostRounds)
        return m_reader.start({again.begin(), again.end()});
    for (const RegisterId id : m_doubtful)
        m_values.erase(id); // never the same twice: it stays unknown
    m_doubtful.clear();
    m_unanswered.clear();
    m_rounds = 0;
    m_phase == Phase::Count ? afterCount() : finish();
}

void McpIdentification::afterCount()
{
    if (const auto global = structure(mcp::decodeGlobalConfig, mcp::reg::kGlobalConfig, 0))
        m_global = *global;
    m_board.version = m_global.version >> 8;
    m_board.motors = std::clamp<int>(m_global.motors, 1, kMaxMotors);
    m_board.motorsCounted = true;
    m_phase = Phase::States;
}

void McpIdentification::describe()
{
    m_phase = Phase::Describe;
    std::vector<RegisterId> ids{mcp::reg::kFwName.bits, mcp::reg::kCtrlStageName.bits};
    for (int motor = 1; motor <= m_board.motors; ++motor)
        for (const mcp::RegisterId id :
            {mcp::reg::kMotorConfig, mcp::reg::kApplicationConfig, mcp::reg::kFocFwConfig,
                mcp::reg::kPwrStageName, mcp::reg::kMotorName, mcp::reg::kScaleConfig})
            ids.push_back(idOf(id, motor));
    m_unanswered = {ids.begin(), ids.end()};
    m_reader.start(ids);
}

std::string McpIdentification::text(mcp::RegisterId id, int motor) const
{
    const auto at = m_values.find(idOf(id, motor));
    const auto *found = at == m_values.end() ? nullptr : std::get_if<std::string>(&at->second);
    return found == nullptr ? std::string() : *found;
}

/// A structure that is there but has no known size shows a firmware that we do not know.
template <class T>
std::optional<T> McpIdentification::structure(
    Result<T, mcp::CodecError> (*decode)(ByteView), mcp::RegisterId id, int motor)
{
    const auto at = m_values.find(idOf(id, motor));
    const auto *bytes = at == m_values.end() ? nullptr : std::get_if<Bytes>(&at->second);
    if (bytes == nullptr)
        return std::nullopt;
    auto decoded = decode(*bytes);
    m_sizesKnown = m_sizesKnown && decoded.has_value();
    return decoded ? std::optional<T>(std::move(*decoded)) : std::nullopt;
}

void McpIdentification::finish()
{
    Identity &identity = m_board.identity;
    std::vector<McpMotorDescription> motors;
    for (int motor = 1; motor <= m_board.motors; ++motor) {
        McpMotorDescription found;
        found.motor = structure(mcp::decodeMotorConfig, mcp::reg::kMotorConfig, motor);
        found.application =
            structure(mcp::decodeApplicationConfig, mcp::reg::kApplicationConfig, motor);
        found.firmware = structure(mcp::decodeFirmwareConfig, mcp::reg::kFocFwConfig, motor);
        found.scale = structure(mcp::decodeScaleConfig, mcp::reg::kScaleConfig, motor);
        identity.powerBoards.push_back(text(mcp::reg::kPwrStageName, motor));
        identity.motorNames.push_back(text(mcp::reg::kMotorName, motor));
        if (std::string &name = identity.motorNames.back(); name.empty() && found.motor)
            name = found.motor->name;
        motors.push_back(std::move(found));
    }
    const bool versionKnown = m_board.version >= kOldestKnown && m_board.version <= kNewestKnown;
    m_board.knownFirmware = versionKnown && m_sizesKnown;
    for (const auto &[id, value] : m_values)
        if (const auto *bytes = std::get_if<Bytes>(&value))
            m_board.structureSizes[id] = bytes->size();
    const auto &first = motors.front().firmware;
    m_board.hso = first && first->hso();

    for (const McpMotorDescription &motor : motors) {
        m_board.scales.push_back(
            m_board.knownFirmware ? scalesOf(motor, m_board.version) : catalog::Scales{});
        m_board.limits.push_back(limitsOf(motor));
        m_board.speedMeasured.push_back(motor.firmware && m_board.knownFirmware
            && (motor.firmware->primarySensor == kEncoder
                || motor.firmware->primarySensor == kHall));
        m_board.sensors.push_back(
            m_board.knownFirmware ? sensorsOf(motor) : std::set<std::uint8_t>());
    }
    const unsigned streams = m_board.linkId == 1 ? m_global.streamsUartB : m_global.streamsUartA;
    m_board.streaming = streamLimitsOf(motors, streams, m_board.streamBytes, m_board.baud);
    const std::uint32_t tableVersion = std::clamp(m_board.version, kOldestKnown, kNewestKnown);
    auto registers =
        catalog::readTable(catalog::builtInTable("mcp"), m_board.hso ? "hso" : "std", tableVersion)
            .value_or(std::vector<catalog::RegisterInfo>());
    if (!m_board.knownFirmware)
        makeRaw(registers);
    m_board.catalog = std::make_shared<const catalog::Catalog>(
        std::move(registers), m_board.motors, m_board.scales, kStart);
    addCapabilities(m_board, motors.front());

    identity.version = versionText(m_board.version);
    identity.protocol = "MCP over ASPEP " + identity.version;
    identity.firmware = text(mcp::reg::kFwName, 0);
    identity.controlBoard = text(mcp::reg::kCtrlStageName, 0);
    identity.watchdog = watchdogIn(identity.firmware);
    for (const McpMotorDescription &motor : motors)
        identity.speedSignals.push_back(speedSignalOf(motor, *m_board.catalog));
    m_board.identified = true;
}

} // namespace drive
