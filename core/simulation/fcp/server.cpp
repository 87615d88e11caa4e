#include "simulation/fcp/server.h"

#include "base/overloaded.h"

#include <algorithm>

namespace simulation {
namespace {

using fcp::CommandId;
using fcp::encodeAck;
using fcp::encodeNack;
using fcp::ErrorCode;
using fcp::FrameCode;

using namespace fcp::number;
// States that commands lead from and to.
constexpr std::uint8_t kIdle = 0, kIdleStart = 3, kRun = 6, kAnyStop = 7, kStopIdle = 9,
                       kFaultOver = 11;
constexpr std::uint8_t kTorqueOnWire = 0, kSpeedOnWire = 1;

/// A number of the register's type, as far as it reaches.
std::int64_t rawNumber(catalog::ValueType type, const StaleBytes &bytes)
{
    switch (type) {
    case catalog::ValueType::U8:
        return bytes.u8(0);
    case catalog::ValueType::S8:
        return static_cast<std::int8_t>(bytes.u8(0));
    case catalog::ValueType::U16:
        return bytes.u16(0);
    case catalog::ValueType::S16:
        return bytes.s16(0);
    case catalog::ValueType::S32:
        return bytes.s32(0);
    default:
        return bytes.u32(0);
    }
}

Bytes littleEndian(std::int64_t value, std::size_t width)
{
    Bytes bytes;
    for (std::size_t i = 0; i < width; ++i)
        bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i)));
    return bytes;
}

} // namespace

FcpServer::FcpServer(FcpRig rig, FcpMachine *machine)
    : m_rig(std::move(rig))
    , m_machine(machine)
{
    if (m_rig.motors.empty())
        m_rig.motors.emplace_back();
    if (m_rig.motors.size() > fcp::kMostMotors)
        m_rig.motors.resize(fcp::kMostMotors);
    m_rig.speedStep_rpm = std::max(m_rig.speedStep_rpm, 1);
    for (FcpMotor &motor : m_rig.motors) {
        if (!motor.revUp.empty())
            motor.revUp.resize(fcp::kRevUpStages);
    }
    m_waiting.resize(m_rig.motors.size());
}

void FcpServer::remember(ByteView payload)
{
    const std::size_t count = std::min(payload.size(), m_buffer.size());
    std::copy_n(payload.begin(), count, m_buffer.begin());
}

Bytes FcpServer::answer(const fcp::Frame &frame)
{
    if (m_hangs)
        return {};
    remember(frame.payload);
    const std::size_t wanted = frame.header >> 5U;
    if (wanted > m_rig.motors.size())
        return encodeNack(ErrorCode::BadMotor);
    if (wanted > 0)
        m_selected = wanted - 1;
    if (m_machine != nullptr)
        m_machine->refresh(m_selected, motor());
    const auto code = static_cast<std::uint8_t>(frame.header & 0x1FU);
    if (!powerPc() && (code == 0 || code == static_cast<std::uint8_t>(FrameCode::SetPosition)))
        return encodeNack(ErrorCode::Undefined);
    if (!fcp::knowsFrame(m_rig.dialect, code))
        return encodeNack(ErrorCode::BadFrameCode);
    return execute(code, frame.payload.size());
}

Bytes FcpServer::execute(std::uint8_t code, std::size_t length)
{
    const StaleBytes in{ByteView(m_buffer)};
    switch (static_cast<FrameCode>(code)) {
    case FrameCode::SetRegister:
        return setRegister(in.u8(0), in.from(1));
    case FrameCode::GetRegister:
        return getRegister(in.u8(0));
    case FrameCode::Execute:
        return command(in.u8(0));
    case FrameCode::GetBoardInfo: {
        const auto version = fcp::firmwareVersionOf(m_rig.firmware);
        Bytes info = fcp::encodeBoardInfo({version.version, version.name});
        for (std::size_t i = 0; m_rig.integersInBoardInfo && i < 3; ++i)
            info[i] = static_cast<std::uint8_t>(info[i] - '0');
        return encodeAck(info);
    }
    case FrameCode::GetFirmwareVersion:
        return encodeAck(fcp::encodeFirmwareVersion(m_rig.firmware));
    case FrameCode::SetRamp:
        ramp(in.s32(0), in.u16(4));
        return encodeAck();
    case FrameCode::GetRevUp:
        return getRevUp(in.u8(0));
    case FrameCode::SetRevUp:
        return setRevUp(in);
    case FrameCode::SetCurrentReference:
        wait({in.s16(0), in.s16(2)});
        return encodeAck();
    case FrameCode::GetProfilerInfo: // a count of registers for each step: a rig shows none
        return m_rig.profiler ? encodeAck(Bytes(length, 0)) : encodeNack(ErrorCode::NoProfiler);
    case FrameCode::SetTorqueRamp:
        torqueRamp(in.s16(0), in.u16(4));
        return encodeAck();
    case FrameCode::SetPosition:
        break;
    }
    return encodeNack(ErrorCode::BadFrameCode);
}

bool FcpServer::isBuilt(const fcp::Register &which) const
{
    using Sensor = FcpMotor::Sensing;
    const Sensor sensing = motor().sensing;
    switch (which.need) {
    case fcp::Need::Nothing:
        return true;
    case fcp::Need::Pll:
        return sensing == Sensor::Pll;
    case fcp::Need::Cordic:
        return sensing == Sensor::Cordic;
    case fcp::Need::Sensor:
        return sensing == Sensor::Encoder || sensing == Sensor::Hall;
    case fcp::Need::FluxWeakening:
        return m_rig.fluxWeakening;
    case fcp::Need::FeedForward:
        return m_rig.feedForward;
    case fcp::Need::Pfc:
        return m_rig.pfc;
    case fcp::Need::Dac:
        return m_rig.dac;
    case fcp::Need::Profiler:
        return m_rig.profiler;
    case fcp::Need::Injection:
    case fcp::Need::Position:
        break;
    }
    return false;
}

std::int64_t FcpServer::valueOf(std::uint8_t id) const
{
    const auto stored = motor().registers.find(id == kIqSpeedMode ? kFluxRef : id);
    switch (id) {
    case kTargetMotor:
        return static_cast<std::int64_t>(m_selected);
    case kFlags:
        return motor().faults;
    case kStatus:
        return motor().state;
    case kControlMode:
        return motor().controlMode;
    case kStages:
        if (stored == motor().registers.end())
            return static_cast<std::int64_t>(motor().revUp.size());
        break;
    default:
        break;
    }
    return stored == motor().registers.end() ? 0 : stored->second;
}

Bytes FcpServer::getRegister(std::uint8_t id)
{
    const fcp::Register *which = fcp::findRegister(m_rig.dialect, id);
    if (which == nullptr || which->readBytes == 0 || !isBuilt(*which))
        return encodeNack(ErrorCode::WriteOnly);
    return encodeAck(littleEndian(valueOf(id), which->readBytes));
}

Bytes FcpServer::setRegister(std::uint8_t id, StaleBytes value)
{
    const fcp::Register *which = fcp::findRegister(m_rig.dialect, id);
    if (which == nullptr || which->writeBytes == 0)
        return encodeNack(ErrorCode::ReadOnly);
    if (id == kTargetMotor)
        return selectMotor(value.u8(0));
    if (id == kControlMode)
        return setControlMode(value.u8(0));
    if (!isBuilt(*which)) {
        const bool ignored = !powerPc() && (id == kDacOut1 || id == kDacOut2);
        return ignored ? encodeAck() : encodeNack(ErrorCode::WrongSet);
    }
    const std::int64_t number = rawNumber(which->info.type, value);
    if (setSpecial(id, number))
        return encodeAck();
    motor().registers[id] = number;
    if (m_machine != nullptr)
        m_machine->written(m_selected, id, number);
    return encodeAck();
}

/// Writes that are commands. Each replaces the whole command that waits, so the first of two quick ones is lost.
bool FcpServer::setSpecial(std::uint8_t id, std::int64_t value)
{
    const auto now = [this](
                         std::uint8_t which) { return static_cast<std::int16_t>(valueOf(which)); };
    const auto digits = static_cast<std::int16_t>(value);
    switch (id) {
    case kTorqueRef:
        wait({digits, now(kFluxRef)});
        return true;
    case kFluxRef:
    case kIqSpeedMode:
        wait({now(kTorqueRef), digits});
        return true;
    case kFinalSpeed:
        ramp(static_cast<std::int32_t>(value), 0);
        return true;
    default:
        return false;
    }
}

Bytes FcpServer::selectMotor(std::uint8_t motor)
{
    if (motor >= m_rig.motors.size())
        return encodeNack(ErrorCode::WrongSet);
    m_selected = motor;
    return encodeAck();
}

Bytes FcpServer::setControlMode(std::uint8_t mode)
{
    if (mode == kTorqueOnWire || mode == kSpeedOnWire) {
        motor().controlMode = mode;
        if (m_machine != nullptr)
            m_machine->setControlMode(m_selected, mode == kTorqueOnWire);
    } else if (powerPc()) {
        return encodeNack(ErrorCode::WrongSet);
    }
    return encodeAck();
}

Bytes FcpServer::command(std::uint8_t id)
{
    const auto known = static_cast<CommandId>(id);
    const bool pfc = known == CommandId::PfcEnable || known == CommandId::PfcDisable
        || known == CommandId::PfcFaultAck;
    if (!fcp::knowsCommand(m_rig.dialect, id) || (pfc && !m_rig.pfc)
        || (known == CommandId::ProfilerStart && !m_rig.profiler))
        return encodeNack(ErrorCode::WrongCommand);
    act(known);
    return powerPc() ? encodeAck(ByteView(&id, 1)) : encodeAck();
}

void FcpServer::act(CommandId id)
{
    if (m_machine != nullptr)
        return m_machine->execute(m_selected, id);
    FcpMotor &motor = this->motor();
    const bool starts = id == CommandId::StartMotor || id == CommandId::StartStop;
    const bool stops =
        id == CommandId::StopMotor || id == CommandId::StartStop || id == CommandId::ProfilerStop;
    if (starts && motor.state == kIdle) {
        motor.state = kIdleStart;
    } else if (stops && motor.state == kRun) {
        motor.state = kAnyStop;
    } else if (id == CommandId::FaultAck && motor.state == kFaultOver) {
        motor.state = kStopIdle;
        motor.faults &= 0xFFFF0000U;
    } else if (id == CommandId::IqdRefClear) {
        motor.registers[kTorqueRef] = 0;
        motor.registers[kFluxRef] = 0;
    }
}

Bytes FcpServer::getRevUp(std::uint8_t stage) const
{
    const auto &stages = motor().revUp;
    if (stage < stages.size())
        return encodeAck(fcp::encodeRevUp(stages[stage]));
    // Firmware reads past its table: what it finds means nothing.
    return powerPc() ? encodeNack(ErrorCode::WrongSet) : encodeAck(fcp::encodeRevUp({}));
}

Bytes FcpServer::setRevUp(const StaleBytes &content)
{
    auto &stages = motor().revUp;
    const std::uint8_t stage = content.u8(0);
    if (powerPc() && stage >= stages.size())
        return encodeNack(ErrorCode::WrongSet);
    if (stages.empty()) {
        m_hangs = true;
        return {};
    }
    if (stage < stages.size())
        stages[stage] = {inSteps(content.s32(1)), content.s16(5), content.u16(7)};
    if (stage < stages.size() && m_machine != nullptr)
        m_machine->setRevUp(m_selected, stage, stages[stage]);
    return encodeAck(); // from stage 5 on firmware writes somewhere else
}

/// Whole steps, cut toward zero and kept in 16 bits.
std::int32_t FcpServer::inSteps(std::int32_t speed_rpm) const
{
    const auto steps = static_cast<std::int16_t>(speed_rpm / m_rig.speedStep_rpm);
    return static_cast<std::int32_t>(std::int64_t{steps} * m_rig.speedStep_rpm);
}

void FcpServer::ramp(std::int32_t speed_rpm, std::uint16_t duration_ms)
{
    const std::int32_t speed = inSteps(speed_rpm);
    motor().registers[kFinalSpeed] = speed;
    motor().controlMode = kSpeedOnWire;
    m_waiting[m_selected] = Ramp{speed};
    if (m_machine != nullptr)
        m_machine->rampSpeed(m_selected, speed, duration_ms);
}

void FcpServer::wait(Currents currents)
{
    motor().controlMode = kTorqueOnWire;
    m_waiting[m_selected] = currents;
    if (m_machine != nullptr)
        m_machine->setCurrents(m_selected, currents.iq, currents.id);
}

void FcpServer::torqueRamp(std::int16_t torque, std::uint16_t duration_ms)
{
    if (m_machine == nullptr)
        return wait({torque, static_cast<std::int16_t>(valueOf(kFluxRef))});
    motor().controlMode = kTorqueOnWire;
    m_machine->rampTorque(m_selected, torque, duration_ms);
}

void FcpServer::setState(std::uint8_t state) { m_rig.motors.front().state = state; }

void FcpServer::setFaults(std::uint32_t flags) { m_rig.motors.front().faults = flags; }

void FcpServer::executeBuffered()
{
    for (std::size_t i = 0; i < m_rig.motors.size(); ++i) {
        FcpMotor &motor = m_rig.motors[i];
        if (motor.state != kRun)
            continue;
        std::visit(Overloaded{
                       [](std::monostate) {},
                       [&](Ramp ramp) { motor.registers[kSpeedRef] = ramp.speed_rpm; },
                       [&](Currents currents) {
                           motor.registers[kTorqueRef] = currents.iq;
                           motor.registers[kFluxRef] = currents.id;
                       },
                   },
            m_waiting[i]);
        m_waiting[i] = std::monostate{};
    }
}

} // namespace simulation
