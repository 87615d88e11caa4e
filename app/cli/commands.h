// The commands, each in a file of its own. Each gives the exit status, or the failure that ends the program.
#pragma once

#include "arguments.h"
#include "conversation.h"
#include "output.h"

namespace cli {

/// What a command that talks to a board is given; the board is connected and identified.
struct Desk {
    const Arguments &arguments;
    Conversation &talk;
    const drive::Identified &board;
    Output &out;

    const catalog::Catalog &catalog() const { return *board.catalog; }
    Outcome<int> checkMotor() const; ///< the motor that is meant, if the board has it
};

Outcome<int> runPorts(Output &out);
/// Meets no board first: the STOPs leave as soon as the port is open.
Outcome<int> runStop(const Arguments &arguments, Output &out);
Outcome<int> runDecode(const Arguments &arguments, Output &out);
Outcome<int> runShow(const Arguments &arguments, Output &out);
Outcome<int> runExport(const Arguments &arguments, Output &out);
Outcome<int> runDiffOfFiles(const Arguments &arguments, Output &out);

Outcome<int> runInfo(Desk &desk);
Outcome<int> runRegisters(Desk &desk);
Outcome<int> runGet(Desk &desk);
Outcome<int> runSet(Desk &desk);
Outcome<int> runStart(Desk &desk);
Outcome<int> runAcknowledge(Desk &desk);
Outcome<int> runRamp(Desk &desk);
Outcome<int> runCapture(Desk &desk);
Outcome<int> runSnapshot(Desk &desk);
Outcome<int> runDiff(Desk &desk);
Outcome<int> runRestore(Desk &desk);
Outcome<int> runRevUp(Desk &desk);
Outcome<int> runTorque(Desk &desk);
Outcome<int> runGains(Desk &desk);
Outcome<int> runHeader(Desk &desk);
Outcome<int> runMotor(Desk &desk);

/// Prints a motor's state.
void printStatus(Output &out, const drive::MotorStatus &status);

} // namespace cli
