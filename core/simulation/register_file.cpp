// Reads and writes by type and element.
#include "simulation/register_file.h"

#include "simulation/board_structures.h"
#include "simulation/simulated_board.h"
#include "simulation/word_registers.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace simulation {

namespace {

using mcp::RegisterId;
using mcp::RegisterType;
using mcp::scalarWidth;
using mcp::Status;

// Element numbers that mcp/protocol.h has no name for.
constexpr unsigned kRevUpStages = 3, kDacUser1 = 57, kDacUser2 = 58; // 8 bits; 16 bits
constexpr unsigned kEstimatedBemf = 3, kObservedBemf = 4, kMotorPower = 109; // 32 bits
constexpr unsigned kIqRef = 37;
constexpr std::size_t kRevUpStageBytes = 8;

Status append(Bytes &out, int room, std::uint32_t value, int width)
{
    if (room < width)
        return Status::NoTxSyncSpace;
    for (int i = 0; i < width; ++i)
        out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    return Status::Ok;
}

/// Texts and structures compare with 16 bits without a sign: what was overdrawn by an unchecked one looks like plenty.
int unsignedRoom(int room) { return static_cast<std::uint16_t>(room); }

Status appendRaw(Bytes &out, int room, const Bytes &value)
{
    if (unsignedRoom(room) < static_cast<int>(value.size()) + 2)
        return Status::NoTxSyncSpace;
    append(out, 2, static_cast<std::uint32_t>(value.size()), 2);
    out.insert(out.end(), value.begin(), value.end());
    return Status::Ok;
}

bool isStub(unsigned element) { return element == kDacUser1 || element == kDacUser2; }

} // namespace

RegisterFile::RegisterFile(const Traits &traits, const BoardOptions &options, Firmware &firmware)
    : m_traits(traits)
    , m_options(options)
    , m_firmware(firmware)
{
}

Status RegisterFile::read(RegisterId id, int room, Bytes &out) const
{
    switch (static_cast<RegisterType>(id.type())) {
    case RegisterType::Bits8:
        return readByte(id, room, out);
    case RegisterType::Bits16:
        return readWord(id, room, out);
    case RegisterType::Bits32:
        return readLong(id, room, out);
    case RegisterType::String:
        return readText(id, room, out);
    case RegisterType::Raw:
        return readRaw(id, room, out);
    }
    return Status::BadDataType;
}

Status RegisterFile::readByte(RegisterId id, int room, Bytes &out) const
{
    if (room < 1)
        return Status::NoTxSyncSpace;
    if (id == mcp::reg::kStatus.withMotor(1))
        return append(out, room, static_cast<std::uint8_t>(m_firmware.state()), 1);
    if (id == mcp::reg::kControlMode.withMotor(1))
        return append(out, room, m_firmware.controlMode(), 1);
    if (id.motor() == 1 && id.element() == kRevUpStages)
        return append(out, room, Firmware::kRevUpStages, 1);
    return Status::UnknownRegister;
}

Status RegisterFile::readWord(RegisterId id, int room, Bytes &out) const
{
    if (room < 2)
        return Status::NoTxSyncSpace;
    if (isStub(id.element()))
        return append(out, room, 0, 2);
    const WordRegister *row = id.motor() == 1 ? findWordRegister(id.element(), m_traits) : nullptr;
    if (row == nullptr || row->use == WordRegister::Use::OnlyLogged)
        return Status::UnknownRegister;
    std::int16_t value =
        row->gain != nullptr ? m_firmware.tuning().*row->gain : m_firmware.variables().*row->signal;
    if (row->use == WordRegister::Use::LoggedSpeed && m_traits.scalesReadSpeeds) {
        const double scaled = value * 6.0 / fullScaleSpeedDigit_rpm(m_firmware);
        value = static_cast<std::int16_t>(std::clamp(scaled, -32768.0, 32767.0));
    }
    return append(out, room, static_cast<std::uint16_t>(value), 2);
}

Status RegisterFile::readLong(RegisterId id, int room, Bytes &out) const
{
    if (room < 4)
        return Status::NoTxSyncSpace;
    if (id.motor() != 1)
        return Status::UnknownRegister;
    const auto square = [](std::int32_t a, std::int32_t b) {
        return static_cast<std::uint32_t>((a * a + b * b) >> 15);
    };
    const Signals &s = m_firmware.variables();
    switch (id.element()) {
    case mcp::reg::kFaultsFlags.element():
        return append(out, room, m_firmware.faultFlags(), 4);
    case mcp::reg::kSpeedMeas.element():
        return append(out, room, static_cast<std::uint32_t>(m_firmware.speed_rpm()), 4);
    case mcp::reg::kSpeedRef.element():
        return append(out, room, static_cast<std::uint32_t>(m_firmware.speedReference_rpm()), 4);
    case kEstimatedBemf:
    case kObservedBemf:
        return append(out, room, square(s.pllBemfAlpha / 2, s.pllBemfBeta / 2), 4);
    case kMotorPower:
        return append(
            out, room, std::bit_cast<std::uint32_t>(static_cast<float>(m_firmware.power_w())), 4);
    default:
        return Status::UnknownRegister;
    }
}

Status RegisterFile::readText(RegisterId id, int room, Bytes &out) const
{
    std::string text;
    if (id == mcp::reg::kFwName)
        text = firmwareName(m_traits, m_options);
    else if (id == mcp::reg::kCtrlStageName)
        text = kControlStageName;
    else if (id == mcp::reg::kPwrStageName.withMotor(1))
        text = kPowerStageName;
    else if (id == mcp::reg::kMotorName.withMotor(1))
        text = kMotorName;
    else
        return Status::UnknownRegister;
    if (unsignedRoom(room) < static_cast<int>(text.size()) + 1)
        return m_traits.asPrinted ? Status::NoTxSyncSpace : Status::StringFormat;
    out.insert(out.end(), text.begin(), text.end());
    out.push_back(0);
    return Status::Ok;
}

Status RegisterFile::readRaw(RegisterId id, int room, Bytes &out) const
{
    if (id == mcp::reg::kGlobalConfig)
        return appendRaw(out, room, globalConfig(m_traits, m_options));
    if (id.motor() != 1)
        return Status::UnknownRegister;
    // The ramps and the references never look at the room: such a response is longer than was agreed.
    const int unchecked = m_traits.asPrinted ? room : INT16_MAX;
    ByteWriter writer;
    switch (id.element()) {
    case mcp::reg::kMotorConfig.element():
        return appendRaw(out, room, motorConfig(m_firmware));
    case mcp::reg::kApplicationConfig.element():
        return appendRaw(out, room, applicationConfig(m_traits, m_firmware));
    case mcp::reg::kFocFwConfig.element():
        return appendRaw(out, room, focFirmwareConfig(m_traits, m_firmware));
    case mcp::reg::kScaleConfig.element():
        return m_traits.asPrinted ? Status::UnknownRegister
                                  : appendRaw(out, room, scaleConfig(m_traits, m_firmware));
    case mcp::reg::kSpeedRamp.element(): {
        const auto ramp = m_firmware.lastSpeedRamp();
        return appendRaw(out, unchecked, writer.s32(ramp.rpm).u16(ramp.ms).take());
    }
    case mcp::reg::kTorqueRamp.element(): {
        const auto ramp = m_firmware.lastTorqueRamp();
        if (m_traits.asPrinted)
            return appendRaw(out, room, writer.s32(ramp.digits).u16(ramp.ms).take());
        return appendRaw(out, unchecked, writer.s16(ramp.digits).u16(ramp.ms).take());
    }
    case mcp::reg::kCurrentRef.element():
        return appendRaw(out, unchecked,
            writer.s16(m_firmware.variables().iQRef).s16(m_firmware.variables().iDRef).take());
    case mcp::reg::kRevUpData.element():
        for (const RevUpStage &stage : m_firmware.revUp())
            writer.s32(stage.rpm).s16(stage.torque).u16(stage.ms);
        return appendRaw(out, room, writer.take());
    default:
        return Status::UnknownRegister;
    }
}

RegisterFile::Written RegisterFile::write(
    RegisterId id, const StaleBytes &value, int available, DatalogRecorder &datalog)
{
    switch (static_cast<RegisterType>(id.type())) {
    case RegisterType::Bits8:
        return {writeByte(id, value.u8(0)), 1};
    case RegisterType::Bits16:
        return {writeWord(id, value.s16(0)), 2};
    case RegisterType::Bits32:
        return {writeLong(id, value.s32(0)), 4};
    case RegisterType::String: {
        int size = 1; // the terminating zero at least
        while (size < available && value.u8(static_cast<std::size_t>(size - 1)) != 0)
            ++size;
        return {Status::ReadOnly, size};
    }
    case RegisterType::Raw: {
        const int size = value.u16(0);
        if (size + 2 > available)
            return {Status::BadRawFormat, 0};
        return {writeRaw(id, value.from(2), size, datalog), size + 2};
    }
    }
    return {Status::BadDataType, 0};
}

Status RegisterFile::writeByte(RegisterId id, std::uint8_t value)
{
    if (id.motor() != 1)
        return Status::UnknownRegister;
    switch (id.element()) {
    case mcp::reg::kControlMode.element():
        m_firmware.setControlMode(value);
        return Status::Ok;
    case mcp::reg::kStatus.element():
    case kRevUpStages:
        return Status::ReadOnly;
    default:
        return Status::UnknownRegister;
    }
}

Status RegisterFile::writeWord(RegisterId id, std::int16_t value)
{
    if (isStub(id.element()))
        return Status::Ok;
    const WordRegister *row = id.motor() == 1 ? findWordRegister(id.element(), m_traits) : nullptr;
    if (row == nullptr || row->use == WordRegister::Use::OnlyLogged)
        return Status::UnknownRegister;
    if (row->use == WordRegister::Use::Reference) {
        const Signals &now = m_firmware.variables();
        if (row->element == kIqRef)
            m_firmware.setCurrentReferences(value, now.iDRef);
        else
            m_firmware.setCurrentReferences(now.iQRef, value);
        return Status::Ok;
    }
    if (row->gain == nullptr)
        return Status::ReadOnly;
    m_firmware.tuning().*row->gain = value;
    return Status::Ok;
}

Status RegisterFile::writeLong(RegisterId id, std::int32_t value)
{
    if (id.motor() != 1)
        return Status::UnknownRegister;
    switch (id.element()) {
    case mcp::reg::kSpeedRef.element():
        m_firmware.rampSpeed(
            {static_cast<std::int16_t>(value), 0}); // the firmware cuts it to 16 bits
        return Status::Ok;
    case mcp::reg::kFaultsFlags.element():
    case mcp::reg::kSpeedMeas.element():
    case kEstimatedBemf:
    case kObservedBemf:
        return Status::ReadOnly;
    default:
        return Status::UnknownRegister; // MOTOR_POWER too
    }
}

bool RegisterFile::isDatalog(RegisterId id) const
{
    const RegisterId mine = m_options.linkId == 1 ? mcp::reg::kAsyncUartB : mcp::reg::kAsyncUartA;
    return id == mine.withMotor(1) || (m_traits.asPrinted && id == mine);
}

Status RegisterFile::writeRaw(
    RegisterId id, const StaleBytes &value, int size, DatalogRecorder &datalog)
{
    if (id == mcp::reg::kGlobalConfig)
        return Status::ReadOnly;
    if (isDatalog(id))
        return datalog.configure(value);
    if (id.motor() != 1)
        return Status::UnknownRegister;
    switch (id.element()) {
    case mcp::reg::kMotorConfig.element():
    case mcp::reg::kApplicationConfig.element():
    case mcp::reg::kFocFwConfig.element():
        return Status::ReadOnly;
    case mcp::reg::kSpeedRamp.element():
        m_firmware.rampSpeed({static_cast<std::int16_t>(value.s32(0)), value.u16(4)});
        return Status::Ok;
    case mcp::reg::kTorqueRamp.element():
        m_firmware.rampTorque({static_cast<std::int16_t>(value.s32(0)), value.u16(4)});
        return Status::Ok;
    case mcp::reg::kCurrentRef.element():
        m_firmware.setCurrentReferences(value.s16(0), value.s16(2));
        return Status::Ok;
    case mcp::reg::kRevUpData.element():
        return writeRevUp(value, size);
    default:
        return Status::UnknownRegister;
    }
}

Status RegisterFile::writeRevUp(const StaleBytes &value, int size)
{
    const auto bytes = static_cast<std::size_t>(size);
    const std::size_t stages = bytes / kRevUpStageBytes;
    if (bytes % kRevUpStageBytes != 0 || stages > Firmware::kRevUpStages)
        return Status::BadRawFormat;
    for (std::size_t i = 0; i < stages; ++i) {
        const StaleBytes stage = value.from(i * kRevUpStageBytes);
        const std::int32_t rpm = static_cast<std::int16_t>(stage.s32(0)); // cut to 16 bits
        m_firmware.setRevUpStage(i, {rpm, stage.s16(4), stage.u16(6)});
    }
    return Status::Ok;
}

Source RegisterFile::source(RegisterId id) const
{
    if (id.motor() != 1)
        return {nullptr, 0};
    if (static_cast<RegisterType>(id.type()) == RegisterType::Bits16) {
        const WordRegister *row = findWordRegister(id.element(), m_traits);
        if (row != nullptr && row->logged())
            return {&(m_firmware.variables().*row->signal), 2};
    } else if (m_options.wide) {
        if (id == mcp::reg::kStatus.withMotor(1))
            return {&m_wideState, 1};
        if (id == mcp::reg::kSpeedMeas.withMotor(1))
            return {&m_wideSpeed, 4};
        if (id == mcp::reg::kSpeedRef.withMotor(1))
            return {&m_wideReference, 4};
        if (id == mcp::reg::kFaultsFlags.withMotor(1))
            return {&m_wideFaults, 4};
    }
    return {nullptr, 0};
}

void RegisterFile::refreshWide()
{
    if (!m_options.wide)
        return;
    m_wideState = static_cast<std::uint8_t>(m_firmware.state());
    m_wideSpeed = m_firmware.speed_rpm();
    m_wideReference = m_firmware.speedReference_rpm();
    m_wideFaults = static_cast<std::int32_t>(m_firmware.faultFlags());
}

} // namespace simulation
