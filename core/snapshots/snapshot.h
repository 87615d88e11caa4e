// Snapshot: what the registers of a board held at one time, with the board's name on it, and how two of them differ.
// Plain values; reading a board, and files, are others' business (session/files/snapshot_json.h).
//
// Registers are told apart by name and motor, because identifiers changed their meaning between firmware versions.
// The order is the catalogue's, motor by motor: the same board always gives the same order.
#pragma once

#include "drive/event.h"

#include <optional>
#include <string>
#include <vector>

namespace snapshots {

using catalog::RegisterId;
using catalog::Value;

struct Entry {
    std::string name; ///< without the motor
    int motor = 0; ///< 0: of the board
    RegisterId id = 0; ///< with the motor, as this firmware numbers it
    std::string group;
    catalog::ValueType type = catalog::ValueType::U16;
    bool tunable = false; ///< as snapshots::tunable() says
    Value value; ///< digits as on the wire
    std::optional<double> shown; ///< of a number: in `unit`; may be not finite
    std::string unit;

    bool isSame(const Entry &other) const { return name == other.name && motor == other.motor; }
};

struct Snapshot {
    drive::Identity board;
    std::vector<Entry> entries;

    const Entry *find(const std::string &name, int motor) const; ///< nullptr if it has none
};

/// What tuning changes: parameters that can be read and written. Nothing that moves a motor by being written, whatever
/// its value: no set-point, mode or command (catalog::Effect).
bool tunable(const catalog::RegisterInfo &info);

enum class Scope : std::uint8_t { Tunable, All };

/// What a snapshot reads, in its order. Stubs are left out: they answer with left-overs.
std::vector<RegisterId> snapshotRegisters(const catalog::Catalog &catalog, Scope scope);

/// Readings that are not Ok are left out: this build does not have them.
Snapshot snapshotOf(const drive::Identity &board, const catalog::Catalog &catalog,
    const std::vector<drive::Reading> &readings);

/// The same digits; NaN is the same as NaN.
bool sameValue(const Value &a, const Value &b);

/// Groups and registers (NAME or NAME@MOTOR) by name, not case-sensitive. Empty: everything.
class Selection {
public:
    Selection() = default;
    explicit Selection(std::vector<std::string> names);

    bool takes(const Entry &entry) const;
    /// The names that fit nothing in there.
    std::vector<std::string> unmatched(const Snapshot &snapshot) const;

private:
    std::vector<std::string> m_names;
};

/// A register with another value, or that only one side has.
struct Difference {
    const Entry *a = nullptr; ///< nullptr: only b has it
    const Entry *b = nullptr; ///< nullptr: only a has it

    const Entry &either() const { return a != nullptr ? *a : *b; }
};

/// In the order of `a`, then what only `b` has. Points into both, which have to stay.
/// Cost: size of a times size of b at worst; both in the same order: their sum.
std::vector<Difference> differences(
    const Snapshot &a, const Snapshot &b, Scope scope, const Selection &selection = {});

} // namespace snapshots
