// Where a session connects to: a value that the connect bar and the command line make.
#pragma once

#include "base/time.h"
#include "drive/protocol.h"

#include <QMetaType>
#include <QString>

#include <optional>
#include <string>

namespace session {

struct Endpoint {
    enum class Kind : std::uint8_t { Simulator, Serial, Trace };
    Kind kind = Kind::Simulator;
    QString path; ///< device path, or the recorded trace's file
    std::uint32_t baud = 1843200; ///< of an SPI device its clock in Hz
    // For Kind::Simulator.
    std::string board; ///< its profile; empty: the usual one
    int boardMotors = 1;
    bool reopen = true; ///< after an unplugged cable, until the port is closed by hand
    Duration patience{}; ///< added to the time-out of every reply, for computers that stall
    drive::Protocol protocol = drive::Protocol::Auto;
    std::optional<drive::Protocol> spoken{}; ///< of Auto: found there before, by the session itself
};

/// The endpoint of a port as the user names it: "sim" and "sim:PROTOCOL" for simulated boards, else the path of a
/// device.
Endpoint endpointFor(
    const QString &path, std::uint32_t baud, drive::Protocol protocol = drive::Protocol::Auto);
/// An SPI device: /dev/spidev0.0, with the ready line behind an @ where there is one.
bool isSpiPath(const QString &path);

/// What can end a port, apart from the user. Neutral; the window and the command line turn it into
/// a sentence.
enum class PortProblem : std::uint8_t {
    None,
    NotFound,
    NoPermission, ///< not in the group that may use serial ports
    Busy, ///< another program, or this one, has it open
    BadSpeed, ///< the driver refuses the baud rate
    Unplugged, ///< it was open and is gone
    TakenOver, ///< this program did not run for a while: its guardian has stopped the motors
    BadFile, ///< a trace that cannot be read
    Other,
};

struct PortError {
    PortProblem problem = PortProblem::None;
    QString detail; ///< the system's own words, or who holds the port; plain text
};

} // namespace session

Q_DECLARE_METATYPE(session::Endpoint)
Q_DECLARE_METATYPE(session::PortError)
