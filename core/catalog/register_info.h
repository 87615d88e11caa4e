// What one register is: its name, how its value is stored, what the number means. Neutral: the same
// for every protocol. Which registers exist on a board is the Catalog's business.
#pragma once

#include "base/bytes.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace catalog {

/// A register as the wire numbers it, motor included where the protocol puts it there.
using RegisterId = std::uint32_t;

enum class ValueType : std::uint8_t { U8, S8, U16, S16, U32, S32, F32, Text, Raw };

/// What people do with the number: a measure, a choice of names, a set of named bits.
enum class Meaning : std::uint8_t { Number, Enumeration, Flags, Boolean };

/// What a number measures; with the board's scales this gives the factor to SI or to the field's
/// usual unit.
enum class Quantity : std::uint8_t {
    Plain, ///< the unit of the table holds as it is
    Current, ///< digits of the current scale -> A
    Voltage, ///< digits of the voltage scale -> V
    Angle, ///< 65536 digits a turn -> degrees (electrical)
    SpeedTenthHz, ///< 0.1 Hz mechanical -> rpm, as the datalog carries it
    Frequency, ///< digits of the frequency scale -> Hz (electrical)
    TurnsPerSecond, ///< of the shaft -> rpm
};

/// Part of a regulator's gain: value / 2^exponent.
enum class Gain : std::uint8_t { None, Numerator, Exponent };

/// A reference that the board's own limits of speed or current bound; a torque by the current it takes.
enum class SetPoint : std::uint8_t { None, Speed, Current, Torque };

/// What a write of a register does besides leaving a number there. Every row of the tables that can be written says it.
enum class Effect : std::uint8_t {
    Unknown, ///< not decided: counts as the worst
    Kept, ///< a parameter: gains, limits, stages of a start-up. Nothing else is ever brought back from a file
    Reference, ///< what a motor or an output follows: set-points, ramps
    Mode, ///< what the control of a motor follows
    Unbounded, ///< drives a motor by what no limit of speed or current holds: a voltage, a duty, an angle
    Command, ///< makes the firmware begin something: its state machine, a profile, a search
    Board, ///< the board itself: its memory, a reset, its link
};
/// The effect that a table's word stands for; empty if it is no such word.
std::optional<Effect> effectOf(std::string_view word);

enum class Access : std::uint8_t { None, Read, Write, ReadWrite };

/// How a register can reach the scope.
enum class Streaming : std::uint8_t { Polled, Fast, StreamOnly /* Fast, but never readable */ };

using Value = std::variant<std::int64_t, double, std::string, Bytes>;

/// A number that is other digits on the wire, such as the exponent of a divisor.
struct WireDigits {
    std::int64_t number = 0, digits = 0;
    bool operator==(const WireDigits &) const = default;
};

struct RegisterInfo {
    RegisterId id = 0; ///< without motor
    std::string name; ///< the field's standard name, e.g. I_Q_MEAS
    std::vector<std::string> aliases; ///< other names in use, e.g. I_Q of the printed documents
    std::string group; ///< where a tree shows it, e.g. "Current loop"
    std::string help;
    std::string unit; ///< of the raw number, as the table says
    ValueType type = ValueType::U16;
    Meaning meaning = Meaning::Number;
    Quantity quantity = Quantity::Plain;
    Access access = Access::Read;
    Streaming streaming = Streaming::Polled;
    Gain gain = Gain::None;
    SetPoint setPoint = SetPoint::None;
    Effect effect = Effect::Unknown; ///< of a write
    std::optional<double> least, greatest; ///< of the raw number of a write; empty: the type's
    int fractionBits = 0; ///< fixed point: the number is raw / 2^fractionBits; 0 for whole digits
    /// Every number it can have, where the wire has other digits for them; empty: it has the number itself.
    std::vector<WireDigits> wire;
    /// A 32-bit register of which the stream carries the upper 16 bits.
    bool streamsUpperHalf = false;
    bool perMotor = true; ///< false: one for the whole board, addressed without a motor
    bool stub = false; ///< answers without effect or with left-overs: never polled
    bool dangerous = false; ///< a write can move or harm something at once

    bool readable() const { return access == Access::Read || access == Access::ReadWrite; }
    bool writable() const { return access == Access::Write || access == Access::ReadWrite; }
    /// Whether a snapshot may bring it back: it holds a parameter, and a write of it moves nothing.
    bool restorable() const { return readable() && writable() && !stub && effect == Effect::Kept; }
    /// Whether a write of it takes the user's explicit word, because nothing here bounds what follows.
    bool takesWord() const
    {
        return effect == Effect::Unknown || effect == Effect::Unbounded || effect == Effect::Command
            || effect == Effect::Board;
    }
};

/// Factor and unit that turn the raw number into what people read: shown = raw * factor [unit].
struct Scale {
    double factor = 1.0;
    std::string unit;
    bool operator==(const Scale &) const = default;
};

/// The number in a value, if it is one.
std::optional<double> asNumber(const Value &value);
/// The value in the digits of the wire, for a caller that shows or writes these.
Value onWire(const RegisterInfo &info, const Value &value);
/// The other way round; empty if the register has no such digits.
std::optional<Value> fromWire(const RegisterInfo &info, const Value &value);

bool isInteger(ValueType type);
std::size_t widthOf(ValueType type); ///< bytes of a scalar; 0 for Text and Raw

} // namespace catalog
