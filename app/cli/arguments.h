// The command line, taken apart. What a command has of its own is read by the command.
#pragma once

#include "drive/protocol.h"
#include "drive/wish.h"
#include "lab/evaluation/tuning.h"
#include "output.h"

#include <QStringList>

#include <cstdint>
#include <optional>
#include <span>

namespace cli {

struct Command;

struct RampArguments {
    int rpm = 0;
    int milliseconds = 0;
};

struct CaptureArguments {
    QStringList fast, slow; ///< register names
    int fastRate = 0; ///< one sample every so many control periods more than one
    int slowRate = 15; ///< one group every so many fast samples more than one
    double seconds = 0.0;
    QString file; ///< CSV; empty: none
    QString recording; ///< empty: none
    bool recordLink = false; ///< the recording holds the bytes of the line, too
    bool start = false;
    bool fromStart = false; ///< the recording begins before the start and the ramp
    bool keepRunning = false;
    std::optional<RampArguments> ramp;
};

/// Of the commands that compare, restore and compute tuning.
struct TuningArguments {
    QString file; ///< -o of snapshot, header and motor
    QStringList only; ///< groups and registers; empty: all
    bool all = false; ///< diff: measured registers too
    bool force = false; ///< restore: on other hardware, too
    bool device = false; ///< diff: one side is the board
    bool set = false; ///< revup: the words are to be written
    bool apply = false; ///< gains: write them
    double bandwidth_radps = 0.0; ///< gains
    double damping = 0.0; ///< gains: of the speed loop; 0: leave it alone
    double inertia_kgm2 = 0.0; ///< gains; 0: the board has to say
    double ke_vrmsPerKrpm = 0.0; ///< gains; 0: the board has to say
    std::optional<double> speedDelay_s; ///< gains; empty: what the board's sensor usually has
    double amps = 0.0; ///< torque
    int milliseconds = 0; ///< torque
};

/// Of step.
struct StepArguments {
    enum class Kind : std::uint8_t { Speed, Torque, Flux, Load, Position };
    Kind kind = Kind::Speed;
    int fromRpm = 0, toRpm = 0; ///< of Speed
    double fromAmps = 0.0, toAmps = 0.0; ///< of Torque and Flux
    double byDegrees = 0.0; ///< of Position
    int in_ms = 0; ///< each move of it; 0: as long as usual
    int repeat = 5;
    int hold_ms = 0; ///< 0: as long as usual
    std::optional<int> rpm; ///< at which the motor turns, of Torque, Flux and Load
};

/// Of response.
struct ResponseArguments {
    bool current = false; ///< of the current loop; else of motor and speed loop
    int seconds = 0; ///< 0: as long as usual
    std::optional<int> rpm; ///< around which it goes
    int amplitude_rpm = 0; ///< 0: as usual
};

/// Of autotune.
struct AutotuneArguments {
    lab::Goal goal = lab::Goal::Medium;
    int seconds = 0; ///< of each response; 0: as long as usual
    bool apply = false;
};

/// Of show and export.
struct RecordingArguments {
    QString file; ///< export: what to write; its ending says the format
    QStringList only; ///< names of signals; empty: all
    std::optional<double> from, to; ///< seconds of the session
    bool continental = false; ///< CSV for spreadsheets with a decimal comma
    bool events = false; ///< show: line by line
};

struct Arguments {
    QString port;
    std::uint32_t baud = 1843200;
    drive::Protocol protocol = drive::Protocol::Auto;
    int patience_ms = 0;
    bool json = false;
    bool raw = false;
    int motor = 1;
    const Command *command = nullptr; ///< nullptr only beside `text`
    QStringList words; ///< the command's own, without options
    RampArguments ramp; ///< of the command `ramp`
    CaptureArguments capture;
    RecordingArguments recording; ///< of show and export
    StepArguments step;
    ResponseArguments response;
    AutotuneArguments autotune;
    bool bothDirections = false; ///< of identify mechanical
    double torqueConstant_nm = 0.0; ///< of identify mechanical, for an ampere; 0: not given
    double tachometer_rpm = 0.0; ///< of pole-pairs
    QString runFile; ///< the recording of an experiment; empty: none is kept
    int runNumber = 0; ///< of evaluate: the one that is meant, from 1; 0: all
    drive::UserLimits limits; ///< --max-rpm and --max-amps
    bool cyclicSetPoints = false; ///< of ramp and capture: with every exchange
    double fullScaleCurrent_a = 0.0; ///< --full-scale-current; 0: not given
    bool expert = false; ///< move motors whose board does not tell its limits
    TuningArguments tuning; ///< of snapshot, diff, restore, revup, torque, gains, header
    std::optional<QString> text; ///< help or version: to be printed instead of doing anything
};

/// @param line  with the program's name in front
/// @param commands  all that there are, in the order of the help
Outcome<Arguments> parseArguments(
    const QStringList &line, std::span<const Command *const> commands);

QString otherBoards(); ///< beside sim, as --port takes them: "sim:legacy, ..."

Outcome<RampArguments> rampOf(const QString &rpm, const QString &milliseconds);

} // namespace cli
