// Facts for tests of the window's parts: a small board with a few registers, and events put into a Device by hand.
#pragma once

#include "widgets/base/device.h"

namespace facts {

inline catalog::RegisterInfo makeRegister(std::uint32_t id, std::string name, std::string group)
{
    catalog::RegisterInfo info;
    info.id = id;
    info.name = std::move(name);
    info.group = std::move(group);
    info.type = catalog::ValueType::S16;
    info.perMotor = false;
    return info;
}

inline constexpr std::uint32_t kSpeed = 0x58, kCurrentA = 0x7D0, kCurrentB = 0x810, kAngle = 0xB50,
                               kVoltage = 0x590, kFlags = 0x18, kName = 0x2A;

inline std::shared_ptr<const catalog::Catalog> smallCatalog()
{
    using namespace catalog;
    std::vector<RegisterInfo> registers;
    registers.push_back(makeRegister(kSpeed, "SPEED_MEAS", "Speed loop"));
    registers.back().type = ValueType::S32;
    registers.back().unit = "rpm";
    registers.push_back(makeRegister(kCurrentA, "I_A", "Current loop"));
    registers.back().quantity = Quantity::Current;
    registers.back().streaming = Streaming::Fast;
    registers.push_back(makeRegister(kCurrentB, "I_B", "Current loop"));
    registers.back().quantity = Quantity::Current;
    registers.back().streaming = Streaming::Fast;
    registers.push_back(makeRegister(kAngle, "STOPLL_EL_ANGLE", "Observer"));
    registers.back().streaming = Streaming::StreamOnly;
    registers.back().access = Access::None;
    registers.push_back(makeRegister(kVoltage, "BUS_VOLTAGE", "Measurements"));
    registers.back().type = ValueType::U16;
    registers.back().unit = "V";
    registers.push_back(makeRegister(kFlags, "FAULTS_FLAGS", "Measurements"));
    registers.back().type = ValueType::U32;
    registers.back().meaning = Meaning::Flags;
    registers.push_back(makeRegister(kName, "MOTOR_NAME", "Board"));
    registers.back().type = ValueType::Text;
    registers.push_back(makeRegister(0x999, "A_STUB", "Board"));
    registers.back().stub = true;
    Scales scales;
    scales.ampsPerDigit = 0.002;
    return std::make_shared<const Catalog>(std::move(registers), 1, std::vector<Scales>{scales});
}

inline drive::Identified identified()
{
    drive::Identified board;
    board.identity.firmware = "ST MC SDK";
    board.identity.version = "6.4.0";
    board.identity.controlBoard = "Control board";
    board.catalog = smallCatalog();
    drive::MotorLimits limits;
    limits.maxSpeedRpm = 4000.0;
    limits.maxCurrentAmps = 32.0;
    limits.nominalCurrentAmps = 5.0;
    limits.speedStepRpm = 6.0; // 0.1 Hz
    board.limits = {limits};
    using drive::MotorState;
    board.states = {{MotorState::Idle, {"IDLE"}},
        {MotorState::Starting, {"ALIGNMENT", "OFFSET_CALIB", "CHARGE_BOOT_CAP"}},
        {MotorState::Starting, {"START"}}, {MotorState::Starting, {"SWITCH_OVER"}},
        {MotorState::Running, {"RUN"}}, {MotorState::Stopping, {"STOP"}},
        {MotorState::FaultNow, {"FAULT_NOW"}}, {MotorState::FaultOver, {"FAULT_OVER"}}};
    board.streaming = {16000.0, 4, 2048, 184320.0};
    return board;
}

inline void feed(widgets::Device &device, std::vector<drive::Event> events)
{
    auto batch = std::make_shared<session::Batch>();
    batch->events = std::move(events);
    device.apply(batch);
}

inline drive::MotorStatus status(drive::MotorState state)
{
    drive::MotorStatus status;
    status.state = state;
    return status;
}

/// Port open, board answering and identified, motor idle.
inline void connectBoard(widgets::Device &device)
{
    device.portChanged(session::PortState::Open, {});
    feed(device,
        {drive::LinkChanged{drive::LinkState::Connected, drive::LinkReason::None}, identified(),
            status(drive::MotorState::Idle)});
}

inline drive::Reading reading(catalog::RegisterId id, catalog::Value value)
{
    drive::Reading reading;
    reading.id = id;
    reading.value = std::move(value);
    return reading;
}

} // namespace facts
