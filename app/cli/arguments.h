// The command line, taken apart. It knows which options each command has, not what they mean to a board.
#pragma once

#include "drive/protocol.h"
#include "drive/wish.h"
#include "failure.h"
#include "recording_arguments.h"
#include "tuning_arguments.h"

#include <QStringList>

#include <cstdint>
#include <optional>

namespace cli {

struct RampArguments {
    int rpm = 0;
    int milliseconds = 0;
};

struct CaptureArguments {
    QStringList fast, slow; ///< register names
    unsigned fastRate = 0; ///< one sample every so many control periods more than one
    unsigned slowRate = 15; ///< one group every so many fast samples more than one
    double seconds = 0.0;
    QString file; ///< CSV; empty: none
    QString recording; ///< empty: none
    bool recordLink = false; ///< the recording holds the bytes of the line, too
    bool start = false;
    bool fromStart = false; ///< the recording begins before the start and the ramp
    bool keepRunning = false;
    std::optional<RampArguments> ramp;
};

struct Arguments {
    QString port;
    std::uint32_t baud = 1843200;
    drive::Protocol protocol = drive::Protocol::Auto;
    int patience_ms = 0;
    bool json = false;
    bool raw = false;
    int motor = 1;
    QString command;
    QStringList words; ///< the command's own, without options
    RampArguments ramp; ///< of the command `ramp`
    CaptureArguments capture;
    RecordingArguments recording; ///< of show and export
    drive::UserLimits limits; ///< --max-rpm and --max-amps
    bool canMove = false; ///< the command can move a motor, or write what moves it
    bool cyclicSetPoints = false; ///< of ramp and capture: with every exchange
    double fullScaleCurrent_a = 0.0; ///< --full-scale-current; 0: not given
    bool expert = false; ///< move motors whose board does not tell its limits
    TuningArguments tuning; ///< of snapshot, diff, restore, revup, torque, gains, header
    std::optional<QString> text; ///< help or version: to be printed instead of doing anything
};

/// @param line  with the program's name in front
Outcome<Arguments> parseArguments(const QStringList &line);

} // namespace cli
