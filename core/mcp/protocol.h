// MCP's numbers: commands, status codes, register identifiers. Shared by the client, the simulated Performer and the
// trace decoder.
// Source: firmware 6.0 to 6.4.2; where the printed text differs the firmware's numbers stand here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mcp {

/// Command word on the wire = (id << 3) | motor.
enum class CommandId : std::uint16_t {
    GetMcpVersion = 0,
    SetRegister = 1,
    GetRegister = 2,
    StartMotor = 3,
    StopMotor = 4,
    StopRamp = 5,
    StartStop = 6, ///< a toggle: in the codec and the simulated board, never sent by us
    FaultAck = 7,
    CpuLoadClear = 8,
    IqdRefClear = 9,
    PfcEnable = 10,
    PfcDisable = 11,
    PfcFaultAck = 12,
    ProfilerCmd = 13,
    SwReset = 15,
    SensorSwitch = 16,
    UserFirst = 32, ///< 32..63
    UserLast = 63,
};

enum class Status : std::uint8_t {
    Ok = 0x00,
    Nok = 0x01,
    CommandUnknown = 0x02,
    DataIdUnknown = 0x03,
    ReadOnly = 0x04,
    UnknownRegister = 0x05,
    StringFormat = 0x06,
    BadDataType = 0x07,
    NoTxSyncSpace = 0x08,
    NoTxAsyncSpace = 0x09,
    BadRawFormat = 0x0A,
    WriteOnly = 0x0B,
    RegisterAccess = 0x0C,
    CallbackNotRegistered = 0x0D,
};

/// "GET_REGISTER", ...; empty if it has none
std::string_view commandName(std::uint16_t commandId);
std::string_view statusName(std::uint8_t status); ///< "CMD_OK", ...; empty if it has none

/// Type field of a register identifier.
enum class RegisterType : std::uint8_t { Bits8 = 1, Bits16 = 2, Bits32 = 3, String = 4, Raw = 5 };

/// Identifier on the wire: bits 15-6 element, 5-3 type, 2-0 motor (0: the board).
struct RegisterId {
    std::uint16_t bits = 0;

    constexpr std::uint8_t type() const { return static_cast<std::uint8_t>((bits >> 3) & 7U); }
    constexpr std::uint8_t motor() const { return static_cast<std::uint8_t>(bits & 7U); }
    constexpr std::uint16_t element() const { return static_cast<std::uint16_t>(bits >> 6); }
    constexpr RegisterId withMotor(unsigned motorNumber) const
    {
        return {static_cast<std::uint16_t>((bits & ~7U) | (motorNumber & 7U))};
    }
    constexpr bool operator==(const RegisterId &) const = default;
};

constexpr RegisterId registerId(unsigned element, RegisterType type, unsigned motor)
{
    return {static_cast<std::uint16_t>(
        (element << 6) | (static_cast<unsigned>(type) << 3) | (motor & 7U))};
}

/// Bytes of a scalar value; 0 for strings, raw values and unknown types.
constexpr std::size_t scalarWidth(std::uint8_t type)
{
    return type == 1 ? 1 : type == 2 ? 2 : type == 3 ? 4 : 0;
}

/// The registers the protocol itself leans on, without motor bits.
namespace reg {
constexpr RegisterId kStatus = registerId(1, RegisterType::Bits8, 0);
constexpr RegisterId kControlMode = registerId(2, RegisterType::Bits8, 0);
constexpr RegisterId kFaultsFlags = registerId(0, RegisterType::Bits32, 0);
constexpr RegisterId kSpeedMeas = registerId(1, RegisterType::Bits32, 0);
constexpr RegisterId kSpeedRef = registerId(2, RegisterType::Bits32, 0);
constexpr RegisterId kFwName = registerId(0, RegisterType::String, 0);
constexpr RegisterId kCtrlStageName = registerId(1, RegisterType::String, 0);
constexpr RegisterId kPwrStageName = registerId(2, RegisterType::String, 0);
constexpr RegisterId kMotorName = registerId(3, RegisterType::String, 0);
constexpr RegisterId kGlobalConfig = registerId(0, RegisterType::Raw, 0);
constexpr RegisterId kMotorConfig = registerId(1, RegisterType::Raw, 0);
constexpr RegisterId kApplicationConfig = registerId(2, RegisterType::Raw, 0);
constexpr RegisterId kFocFwConfig = registerId(3, RegisterType::Raw, 0);
constexpr RegisterId kScaleConfig = registerId(4, RegisterType::Raw, 0);
constexpr RegisterId kAdcOffset = registerId(5, RegisterType::Raw, 0); ///< HSO only
constexpr RegisterId kSpeedRamp = registerId(6, RegisterType::Raw, 0);
constexpr RegisterId kTorqueRamp = registerId(7, RegisterType::Raw, 0);
constexpr RegisterId kRevUpData = registerId(8, RegisterType::Raw, 0);
constexpr RegisterId kCurrentRef = registerId(13, RegisterType::Raw, 0);
constexpr RegisterId kPositionRamp = registerId(14, RegisterType::Raw, 0);
/// Datalog; sent with motor 1: 0x0529.
constexpr RegisterId kAsyncUartA = registerId(20, RegisterType::Raw, 0);
constexpr RegisterId kAsyncUartB = registerId(21, RegisterType::Raw, 0);
constexpr RegisterId kAsyncStLink = registerId(22, RegisterType::Raw, 0);
constexpr RegisterId kHallHewPins = registerId(28, RegisterType::Raw, 0);
constexpr RegisterId kHallConnectedPins = registerId(29, RegisterType::Raw, 0);
constexpr RegisterId kHallPhaseShift = registerId(30, RegisterType::Raw, 0);
constexpr RegisterId kBemfAdcConf = registerId(31, RegisterType::Raw, 0); ///< six-step
} // namespace reg

} // namespace mcp
