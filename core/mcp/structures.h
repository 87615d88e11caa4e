// The raw structures of MCP: what stands behind the u16 size of a raw value. Decoded by the size that the board
// reports, because layouts changed between firmware versions; every other size is an error. All packed, little-endian.
#pragma once

#include "mcp/value.h"

#include <optional>

namespace mcp {

struct GlobalConfig { // 10 bytes
    std::uint32_t version = 0; ///< 0xMMmmpp00
    std::uint8_t motors = 1;
    std::uint8_t flags = 0; ///< bit 0 ST-LINK, 1 UART A, 2 UART B
    std::uint8_t streamsUartA = 0; ///< signals that can be logged at once
    std::uint8_t streamsUartB = 0;
    std::uint8_t streamsStLink = 0;
    bool operator==(const GlobalConfig &) const = default;
};

struct MotorConfig { // 60 bytes; ratedFlux: V/Hz in HSO and ZeST builds, else Ke in V/krpm
    float polePairs = 0, ratedFlux = 0, rs = 0, skinFactor = 0, lq = 0, ld = 0, maxCurrent = 0,
          copperMass = 0, coolingTau = 0;
    std::string name; ///< up to 23 bytes; the device's text
    bool operator==(const MotorConfig &) const = default;
};

struct ApplicationConfig { // 16 bytes from 6.2, 14 before
    std::uint32_t maxSpeedRpm = 0;
    float maxReadableAmps = 0;
    float nominalAmps = 0; ///< in the short form converted from digits with maxReadableAmps / 32768
    std::uint16_t nominalVolts = 0;
    std::uint8_t driveType = 0; ///< 0 FOC, 1 six-step, 2 ACIM
    std::optional<std::uint16_t> nominalDigits; ///< as the short form has it
    bool operator==(const ApplicationConfig &) const = default;
};

struct FirmwareConfig { // FOC and ACIM 14 bytes; six-step 10, 11 (6.3.2) or 13 (6.4.2)
    bool sixStep = false;
    std::uint8_t primarySensor = 0;
    std::uint8_t auxiliarySensor = 0; ///< not in six-step
    std::uint8_t topology = 0;
    std::uint8_t focRate = 1; ///< PWM periods a control period; not in six-step
    std::uint32_t pwmHz = 0;
    std::uint16_t mediumHz = 0;
    std::uint16_t flags1 = 0;
    std::optional<std::uint16_t> flags2;
    std::optional<std::uint8_t> driveMode; ///< six-step: 0 voltage, 1 current
    bool operator==(const FirmwareConfig &) const = default;
    /// HSO and ZeST builds: other registers, per unit, and a rated flux in V/Hz.
    bool hso() const { return !sixStep && (primarySensor == 5 || primarySensor == 6); }
};

struct ScaleConfig { // 12 bytes
    float voltage = 0, current = 0, frequency = 0; ///< what one digit is worth: V, A, rpm
    bool operator==(const ScaleConfig &) const = default;
};

Result<GlobalConfig, CodecError> decodeGlobalConfig(ByteView raw);
Result<MotorConfig, CodecError> decodeMotorConfig(ByteView raw);
Result<ApplicationConfig, CodecError> decodeApplicationConfig(ByteView raw);
Result<FirmwareConfig, CodecError> decodeFirmwareConfig(ByteView raw);
Result<ScaleConfig, CodecError> decodeScaleConfig(ByteView raw);

} // namespace mcp
