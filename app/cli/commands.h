// The commands: each is a row in a file of its own, and main.cpp has the list of them.
#pragma once

#include "arguments.h"
#include "conversation.h"
#include "option_values.h"
#include "output.h"

namespace cli {

/// What a command that talks to a board is given; the board is connected and identified.
struct Desk {
    const Arguments &arguments;
    Conversation &talk;
    const drive::Identified &board;
    Output &out;

    const catalog::Catalog &catalog() const { return *board.catalog; }
};

/// A command. Its functions give the exit status, or the failure that ends the program.
struct Command {
    const char *name = "";
    const char *words = ""; ///< after the name
    const char *help = "";
    int least = 0, most = 0; ///< number of words
    /// Its own, beside those that follow from the members below.
    std::span<const OptionText> options = {};
    /// Its own words and options.
    Outcome<bool> (*read)(const Given &given, Arguments &arguments) = nullptr;
    bool needsPort = true;
    bool canMove = false; ///< it can move a motor, or write what moves it
    /// A motor that it moved goes back to what it was, or is stopped if this program dies.
    bool ownsMotor = false;
    bool ofOneMotor = false; ///< it has --motor, and runs if the board has that one
    bool numbers = false; ///< its words may be negative
    Outcome<int> (*run)(Desk &) = nullptr; ///< with a board
    /// Before a board is met, or without one. Where both are there, this is for runs without --port.
    Outcome<int> (*runAlone)(const Arguments &, Output &) = nullptr;
};

constexpr int kAnyWords = 1'000'000;
constexpr OptionText kRawOption{"raw", "", "Numbers as they are on the wire."};
constexpr OptionText kOutputOption{
    "o,output", "FILE", "The file to write; it appears whole or not at all."};
constexpr OptionText kOnlyOption{
    "only", "GROUP", "Only this group or register; several are separated by commas."};
constexpr OptionText kCyclicOption{"cyclic-setpoints", "",
    "Set-points travel with every exchange (MCB); begins while the motor stands."};

extern const Command kPorts, kInfo, kRegisters, kGet, kSet, kStart, kStop, kAcknowledge, kRamp,
    kCapture, kSnapshot, kDiff, kRestore, kRevUp, kTorque, kGains, kMotor, kHeader, kShow, kExport,
    kDecode, kStep, kIdentify, kPolePairs, kResponse, kAutotune, kExperiment, kEvaluate;

/// Prints a motor's state.
void printStatus(Output &out, const drive::MotorStatus &status);

} // namespace cli
