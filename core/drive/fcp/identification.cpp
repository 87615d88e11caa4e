#include "drive/fcp/identification.h"

#include "drive/values.h"
#include "motor/ramp.h"

namespace drive {

namespace {

using fcp::Dialect;

using namespace fcp::number;
constexpr catalog::StartRegisters kStart{
    {"CONTROL_MODE"}, {}, {"RAMP_FINAL_SPEED", "SPEED_REF"}, {"I_Q_REF"}};
constexpr int kMostLosses = 4; ///< of one question; the link itself gives up earlier
constexpr auto kBadMotor = static_cast<std::uint8_t>(fcp::ErrorCode::BadMotor);
constexpr auto kNoTarget = static_cast<std::uint8_t>(fcp::ErrorCode::NoTargetDrive);

} // namespace

void FcpIdentification::restart(const fcp::BoardInfo &info)
{
    m_info = info;
    m_version.reset();
    m_phase = Phase::Version;
    m_powerPcRegister = m_stm32Register = false;
    m_doubt.clear();
    m_reader.clear();
    m_values.clear();
    m_readings.clear();
    m_losses = 0;
    m_board.forget();
}

std::optional<fcp::Request> FcpIdentification::nextRequest(TimePoint)
{
    switch (m_phase) {
    case Phase::Version:
        return fcpRequest(1, fcp::GetFirmwareVersion{});
    case Phase::OnlyPowerPc:
        return fcpRequest(1, fcp::GetRegister{kOnlyPowerPc});
    case Phase::OnlyStm32:
        return fcpRequest(1, fcp::GetRegister{kOnlyStm32});
    case Phase::Motors:
        return fcpRequest(m_board.motors + 1, fcp::GetRegister{kStatus});
    case Phase::Registers:
        break;
    }
    return m_reader.nextRequest();
}

void FcpIdentification::onResponse(const fcp::Reply &response, TimePoint now)
{
    m_losses = 0;
    const auto *ack = std::get_if<fcp::Ack>(&response);
    switch (m_phase) {
    case Phase::Version:
        if (ack != nullptr)
            if (const auto version = fcp::decodeFirmwareVersion(ack->data)) {
                m_version = *version;
                return decideDialect();
            }
        m_phase = Phase::OnlyPowerPc;
        return;
    case Phase::OnlyPowerPc:
        m_powerPcRegister = ack != nullptr;
        m_phase = Phase::OnlyStm32;
        return;
    case Phase::OnlyStm32:
        m_stm32Register = ack != nullptr;
        return decideDialect();
    case Phase::Motors:
        if (ack != nullptr) {
            if (++m_board.motors < static_cast<int>(fcp::kMostMotors))
                return;
        } else {
            const auto code = nackCode(response);
            const bool noSuchMotor = code == kBadMotor;
            if (!noSuchMotor && code != kNoTarget)
                m_doubt = "it does not tell how many motors it has";
        }
        return probeRegisters();
    case Phase::Registers:
        for (Reading &reading : m_reader.onResponse(response, now))
            if (reading.status == ReadStatus::Ok) {
                m_values[reading.id] = reading.value;
                m_readings.push_back(std::move(reading));
            }
        if (m_reader.finished())
            finish();
    }
}

void FcpIdentification::onNoResponse(std::optional<bool>, TimePoint)
{
    if (m_phase == Phase::Registers) {
        m_reader.onNoResponse();
        if (m_reader.finished())
            finish();
    } else if (++m_losses >= kMostLosses) {
        m_doubt = "it did not answer all that identifies it";
        probeRegisters();
    }
}

void FcpIdentification::decideDialect()
{
    const bool powerPc = m_powerPcRegister && !m_stm32Register;
    const bool named = m_info.name.starts_with("STM32") || m_info.name.starts_with("ST MC");
    const bool stm32 = m_version || (!m_powerPcRegister && (m_stm32Register || named));
    const Dialect found = powerPc ? Dialect::PowerPc : Dialect::Stm32;
    m_board.dialect = m_chosen.value_or(found);
    if (powerPc == stm32 && !m_chosen)
        m_doubt = "it cannot be told which dialect it speaks";
    else if (m_chosen && (stm32 || powerPc) && *m_chosen != found)
        m_doubt = "it speaks another dialect than the chosen one";
    m_board.motors = 1;
    m_phase = Phase::Motors;
}

void FcpIdentification::probeRegisters()
{
    m_board.motorsCounted = true;
    m_phase = Phase::Registers;
    std::vector<RegisterId> ids;
    const auto all = fcpRegisters(m_board.dialect, false);
    for (int motor = 1; motor <= m_board.motors; ++motor)
        for (const catalog::RegisterInfo &info : all)
            if (info.readable() && (info.perMotor || motor == 1))
                ids.push_back(catalog::Catalog::withMotor(info, motor));
    m_reader.start(ids);
}

void FcpIdentification::addLimits()
{
    for (int motor = 1; motor <= m_board.motors; ++motor) {
        MotorLimits limits;
        limits.speedStepRpm = motor::kSpeedStep_rpm;
        limits.wireRpm = motor::kMostInSteps_rpm;
        const auto fastest = m_values.find(fcpId(kMaxSpeed, motor));
        if (fastest != m_values.end())
            limits.maxSpeedRpm = asNumber(fastest->second).value_or(0.0);
        m_board.limits.push_back(limits);
        m_board.scales.emplace_back();
    }
}

void FcpIdentification::addCapabilities()
{
    m_board.capabilities.clear();
    const std::string readOnly = "Read-only: " + m_doubt + ".";
    const auto tell = [&](Feature feature, const std::string &reason) {
        m_board.tell(feature, m_board.knownFirmware ? reason : readOnly);
    };
    for (const Feature feature : {Feature::Start, Feature::AcknowledgeFaults, Feature::SpeedRamp,
             Feature::WriteRegisters, Feature::CurrentScale})
        tell(feature, {});
    m_board.tell(Feature::Stop, {});
    // One motor with a scale is enough; of the others each set-point is refused by itself.
    std::string noAmps = kNoCurrentScale;
    for (int motor = 1; motor <= m_board.motors; ++motor)
        if (m_board.ampsPerDigit(motor) > 0.0)
            noAmps.clear();
    const bool torqueRamp =
        m_board.dialect == Dialect::Stm32 && m_version && m_version->version >= "5.4.2";
    tell(
        Feature::TorqueRamp, torqueRamp ? noAmps : "Only firmware from 5.4.2 on has torque ramps.");
    tell(Feature::CurrentReference, noAmps);
    m_board.tell(Feature::Stream,
        "Boards of this protocol record nothing by themselves: signals are read one after the "
        "other.");
    m_board.tell(Feature::PositionRamp, "This protocol moves no shaft to a position.");
    m_board.tell(Feature::CyclicSetPoints, kNoCycle);
}

void FcpIdentification::finish()
{
    bool revUp = false;
    for (int motor = 1; motor <= m_board.motors; ++motor) {
        const auto stages = m_values.find(fcpId(kStages, motor));
        const bool has = stages != m_values.end() && asNumber(stages->second).value_or(0.0) > 0.0;
        revUp = revUp || has;
        if (!has)
            m_board.missing.insert(kFcpRevUp | static_cast<RegisterId>(motor));
    }
    if (m_reader.gaveUp() && m_doubt.empty())
        m_doubt = "it did not answer all that identifies it";
    m_board.knownFirmware = m_doubt.empty();
    std::vector<catalog::RegisterInfo> registers;
    for (catalog::RegisterInfo &info : fcpRegisters(m_board.dialect, revUp)) {
        const bool asked = info.readable() && !isFcpRevUp(info.id);
        bool there = !asked;
        for (int motor = 1; motor <= m_board.motors; ++motor) {
            const RegisterId id = catalog::Catalog::withMotor(info, motor);
            if (m_values.contains(id))
                there = true;
            else if (asked)
                m_board.missing.insert(id);
        }
        if (!there)
            continue;
        if (!m_board.knownFirmware && info.writable())
            info.access = info.readable() ? catalog::Access::Read : catalog::Access::None;
        registers.push_back(std::move(info));
    }
    addLimits();
    m_board.catalog = std::make_shared<const catalog::Catalog>(
        std::move(registers), m_board.motors, m_board.scales, kStart);
    m_board.streaming.linkBytesPerSecond = m_board.bytesPerSecond;
    constexpr double kBytesOfRead = 4.0 + 7.0; // the question, and an answer of four bytes
    m_board.streaming.readsPerSecond = m_board.bytesPerSecond / kBytesOfRead;
    addCapabilities();

    const bool powerPc = m_board.dialect == Dialect::PowerPc;
    const auto board = [&](std::uint8_t number) {
        const auto at = m_values.find(fcpId(number, 0));
        return at == m_values.end()
            ? std::string()
            : "board " + std::to_string(static_cast<long>(asNumber(at->second).value_or(0.0)));
    };
    Identity &identity = m_board.identity;
    identity.protocol = powerPc ? "MCP PowerPC" : "MCP legacy";
    if (!m_doubt.empty())
        identity.protocol += " (read-only: " + m_doubt + ")";
    identity.firmware = m_version ? m_version->name : m_info.name;
    identity.version =
        m_version && !m_version->version.empty() ? m_version->version : m_info.version;
    identity.evidence = m_version ? "it answers GET_FW_VERSION, as STM32 boards do"
        : powerPc ? "it refuses GET_FW_VERSION and has registers of PowerPC boards only"
                  : "it refuses GET_FW_VERSION, but has registers of STM32 boards only";
    identity.controlBoard = board(kControlBoard);
    identity.powerBoards = {board(kPowerBoard)};
    m_board.identified = true;
}

} // namespace drive
