// The registers of the older serial protocol as the window knows them: under the field's standard names where there is
// one (the documents' own stay as aliases), with the numbers that these names stand for everywhere. Two numbers differ
// on the wire: the control mode (there 0 torque, 1 speed) and the divisors of the speed loop (there the divisor itself,
// here its exponent of two). The stages of the rev-up, which have requests of their own there, are one raw register.
//
// An identifier holds the register's number above three bits for the motor.
#pragma once

#include "catalog/catalog.h"
#include "drive/event.h"
#include "fcp/register_table.h"
#include "fcp/request.h"

#include <optional>
#include <vector>

namespace drive {

constexpr unsigned kFcpMotorBits = 3;
constexpr RegisterId kFcpRevUp = 0x100U << kFcpMotorBits; ///< the raw one: 5 stages

constexpr RegisterId fcpId(std::uint8_t number, int motor)
{
    return (RegisterId{number} << kFcpMotorBits) | static_cast<RegisterId>(motor & 7);
}
/// The register's number on the wire; only if it is not the raw one.
constexpr std::uint8_t fcpNumber(RegisterId id)
{
    return static_cast<std::uint8_t>(id >> kFcpMotorBits);
}
constexpr bool isFcpRevUp(RegisterId id) { return (id & ~RegisterId{7}) == kFcpRevUp; }
/// The motor for the frame: never 0, which is the one that was selected last.
constexpr std::uint8_t fcpMotor(RegisterId id)
{
    return static_cast<std::uint8_t>((id & 7U) == 0 ? 1U : id & 7U);
}

/// What a board of the dialect can have. @param revUp  with the stages of the rev-up
std::vector<catalog::RegisterInfo> fcpRegisters(fcp::Dialect dialect, bool revUp);

/// The number in an answer of a length that fits; empty if it means nothing that the name can stand for.
std::optional<Value> fcpValue(const fcp::Register &which, ByteView data);

/// The bytes of a write in the full width that firmware reads. Fails with the reason.
Result<Bytes, std::string> fcpBytes(const fcp::Register &which, const Value &value);

} // namespace drive
