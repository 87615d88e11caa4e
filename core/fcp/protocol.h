// Numbers of the older serial protocol: frame codes, commands, errors. Shared by both its dialects, the client and the
// simulated boards.
// Source: firmware 5.4.3 run on a PC for STM32, the printed text alone for PowerPC.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fcp {

enum class Dialect : std::uint8_t {
    Stm32, ///< motor control SDK 3 to 5
    PowerPc, ///< its relative, of which no firmware is public
};

/// Bits 4..0 of a request's header.
enum class FrameCode : std::uint8_t {
    SetRegister = 0x01,
    GetRegister = 0x02,
    Execute = 0x03,
    GetBoardInfo = 0x06,
    SetRamp = 0x07,
    GetRevUp = 0x08,
    SetRevUp = 0x09,
    SetCurrentReference = 0x0A,
    GetProfilerInfo = 0x0B,
    GetFirmwareVersion = 0x0C,
    SetTorqueRamp = 0x0D, ///< printed as a read; firmware from 5.4.2 on moves the motor
    SetPosition = 0x12,
};

/// Whole header bytes of what a board sends: never to be taken apart like a request's.
constexpr std::uint8_t kAckHeader = 0xF0, kNackHeader = 0xFF, kStartNoticeHeader = 0xE0;

enum class CommandId : std::uint8_t {
    StartMotor = 0x01,
    StopMotor = 0x02,
    StopRamp = 0x03,
    Reset = 0x04, ///< acknowledged by 5.x, does nothing
    Ping = 0x05, ///< acknowledged by 5.x, does nothing
    StartStop = 0x06,
    FaultAck = 0x07,
    EncoderAlign = 0x08,
    IqdRefClear = 0x09,
    PfcEnable = 0x0A,
    PfcDisable = 0x0B,
    PfcFaultAck = 0x0C,
    ProfilerStart = 0x0D,
    ProfilerStop = 0x0E, ///< acts like a stop
};

enum class ErrorCode : std::uint8_t {
    Undefined = 0x00, ///< left over in firmware, means nothing
    BadFrameCode = 0x01,
    ReadOnly = 0x02, ///< or unknown, on a write
    WriteOnly = 0x03, ///< or unknown or not in this build, on a read
    NoTargetDrive = 0x04,
    WrongSet = 0x05, ///< value refused, or not in this build, on a write
    CommandUnused = 0x06,
    WrongCommand = 0x07,
    Overrun = 0x08,
    Timeout = 0x09,
    BadChecksum = 0x0A,
    BadMotor = 0x0B,
    NoProfiler = 0x0C,
};

/// Registers that mean more to a program than their row in the table says.
namespace number {
constexpr std::uint8_t kTargetMotor = 0x00, kFlags = 0x01, kStatus = 0x02, kControlMode = 0x03,
                       kSpeedRef = 0x04, kTorqueRef = 0x08, kFluxRef = 0x0C, kMotorPower = 0x1B,
                       kDacOut1 = 0x1C, kDacOut2 = 0x1D, kSpeedMeas = 0x1E, kStages = 0x22,
                       kMaxSpeed = 0x3F, kIqSpeedMode = 0x41, kFf1Q = 0x46, kFf1D = 0x47,
                       kFf2 = 0x48, kFinalSpeed = 0x5B, kOnlyPowerPc = 0x5C, kOnlyStm32 = 0x6E,
                       kSpeedKpDiv = 0x6E, kSpeedKiDiv = 0x6F, kUid = 0x70, kControlBoard = 0x72,
                       kPowerBoard = 0x73;
} // namespace number

/// Bits 7..5 of a request's header; 0 is the motor selected last.
constexpr unsigned kMostMotors = 7;
constexpr std::size_t kRevUpStages = 5;
constexpr std::size_t kStageBytes = 8;

/// Its name as the documents have it: "BAD_CRC", ...; empty if there is none.
std::string_view errorName(std::uint8_t code);

/// Whether the dialect's documents or firmware know the frame code or command.
bool knowsFrame(Dialect dialect, std::uint8_t code);
bool knowsCommand(Dialect dialect, std::uint8_t id);

} // namespace fcp
