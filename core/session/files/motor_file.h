// Motors from JSON files, and back: our own form, which the simulator turns into a machine and the window compares with
// a board, and what ST's tools save of a motor. docs/motor-file.md describes both. A file is taken whole or not at all.
#pragma once

#include "base/result.h"
#include "motor/sheet.h"
#include "simulation/plant/parameters.h"

#include <QByteArray>
#include <QString>

#include <set>
#include <string>
#include <vector>

namespace session {

/// Why a file is not used: what is wrong, and where. For sentences in any language.
struct MotorFileError {
    enum class Kind : std::uint8_t {
        Unreadable, ///< detail: the system's words
        TooLarge,
        NotJson, ///< at `line`; detail: what the parser says
        NotAnObject, ///< place: of the section, empty for the whole; detail: the keys it should have
        UnknownKey, ///< place: the key with its section; detail: the keys that there are
        UnknownPreset,
        WrongValue, ///< at `place`, which takes `wanted`
        Missing, ///< place: a key that another one needs
        RangeBelowSupply, ///< inverter.busRange_v
    };
    /// What may stand at a place.
    enum class Wanted : std::uint8_t { Number, WholeNumber, YesOrNo, Text };

    Kind kind = Kind::Unreadable;
    std::string place{}; ///< e.g. "motor.rs_ohm"
    std::size_t line = 0; ///< from 1
    std::string detail{};
    Wanted wanted = Wanted::Number;
    double least = 0.0, most = 0.0; ///< of a text: bytes
};

/// The error as a command line says it: "FILE: motor.rs_ohm: must be a number from 1e-04 to 1000".
std::string motorFileErrorText(const std::string &file, const MotorFileError &error);

struct MotorFile {
    enum class Origin : std::uint8_t {
        Own,
        St, ///< of a profiler, or of a motor library
    };
    /// What the user should know of how it was read.
    enum class Note : std::uint8_t {
        InductanceInMillihenry, ///< the file does not say; henry would make no motor
        OneInductanceOnly, ///< a salient motor, of which only one inductance was measured
        UnknownKeysLeftOut,
    };

    Origin origin = Origin::Own;
    simulation::PlantParameters machine; ///< with a preset's figures where the file has none
    std::set<std::string> given; ///< "motor.rs_ohm": in the file, or in the preset that it names
    std::vector<Note> notes;

    /// Only what was given.
    motor::MotorSheet sheet() const;
};

Result<MotorFile, MotorFileError> readMotor(const QByteArray &json);
Result<MotorFile, MotorFileError> readMotorFile(const QString &path);

/// In our own form, such as readMotor() takes: what the description has, as far as a machine can have it.
QByteArray motorJson(const motor::MotorSheet &sheet);

} // namespace session
