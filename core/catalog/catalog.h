// Which registers a board has, found by id or by name. Immutable once made; shared between threads
// as shared_ptr<const Catalog>.
#pragma once

#include "base/result.h"
#include "catalog/control_mode.h"
#include "catalog/csv.h"
#include "catalog/register_info.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace catalog {

/// Factors of one motor's digits, as the board reports them. Zero: not known, raw digits are shown.
struct Scales {
    double ampsPerDigit = 0.0;
    double voltsPerDigit = 0.0;
    double hertzPerDigit = 0.0; ///< of Frequency: only where values are per unit
    double rpmPerSpeedDigit = 6.0; ///< of SpeedTenthHz in the datalog: 0.1 Hz = 6 rpm
    /// Of the same registers when read one by one (differs up to firmware 6.3).
    double rpmPerReadDigit = 6.0;
    bool operator==(const Scales &) const = default;
};

/// Which registers say where a START goes, by name: of each kind the first that a board has. What is followed in the
/// end, not the ramp on the way to it; `ramp` is the last one, s32 rpm and u16 ms, `torqueRamp` that of the current,
/// s16 digits and u16 ms.
struct StartRegisters {
    std::array<std::string_view, 2> mode, ramp, speed, current;
    ControlMode (*controlOf)(std::int64_t mode) = controlModeOf;
    std::string_view torqueRamp = {};
    /// Where one is not 0 the motor follows what is no set-point: an open loop, a potentiometer.
    std::array<std::string_view, 2> sources = {};
    /// What says how it goes to a speed, where each one that is asked for writes that; the mode last.
    std::array<std::string_view, 3> way = {};
    bool isSource(std::string_view name) const { return name == sources[0] || name == sources[1]; }
};

class Catalog {
public:
    Catalog() = default;
    Catalog(std::vector<RegisterInfo> registers, int motors, std::vector<Scales> scales,
        const StartRegisters &start = {});

    const std::vector<RegisterInfo> &registers() const { return m_registers; }
    int motors() const { return m_motors; }
    const StartRegisters &start() const { return m_start; }

    /// The register an id (with motor) belongs to; nullptr if the table does not have it.
    const RegisterInfo *find(RegisterId id) const;
    /// By name or alias, not case-sensitive; nullptr if there is none.
    const RegisterInfo *find(std::string_view name) const;
    /// NAME or NAME@MOTOR to the id for the wire. Motor defaults to 1 for registers of a motor.
    /// Empty if the name or the motor does not exist.
    std::optional<RegisterId> resolve(std::string_view nameAtMotor) const;

    /// For the wire; a register of the board has the same with each motor.
    static RegisterId withMotor(const RegisterInfo &info, int motor);
    int motorOf(RegisterId id) const; ///< 0 for registers of the board

    /// Name for people: the register's, "@2" behind it where a board has several motors, the id in
    /// hex if unknown.
    std::string nameOf(RegisterId id) const;

    const Scales &scales(int motor) const; ///< of the nearest motor that there is

    /// What a value read one by one means, and what a streamed sample means.
    Scale readScale(RegisterId id) const;
    Scale streamScale(RegisterId id) const;

private:
    Scale scaleOf(RegisterId id, double rpmPerDigit) const;

    std::vector<RegisterInfo> m_registers;
    int m_motors = 1;
    std::vector<Scales> m_scales; ///< one a motor
    StartRegisters m_start;
    std::unordered_map<RegisterId, std::size_t> m_byId;
    std::unordered_map<std::string, std::size_t> m_byName; ///< upper case, aliases included
};

/// Names of registers are compared in this form: the letters of ASCII in capitals.
std::string upper(std::string_view text);

/// Reads a register table (resources/registers/README.md has the columns).
/// @param family   rows of this family only
/// @param version  firmware as 0xMMmmpp; rows that came later or went earlier are left out
Result<std::vector<RegisterInfo>, TableError> readTable(
    std::string_view csv, std::string_view family, std::uint32_t version);

/// The CSV text of `resources/registers/<name>.csv`, built into the library so that core needs no file access; an empty
/// view if there is none.
std::string_view builtInTable(std::string_view name);

} // namespace catalog
