// What the board says about the motor that is meant and about itself, asked for by a command.
#pragma once

#include "commands.h"
#include "drive/motor_view.h"
#include "drive/start_target.h"

namespace cli {

/// What it does not say is 0.
Outcome<drive::MotorFacts> readMotorFacts(Desk &desk);

/// What a start would go to, read now.
Outcome<drive::StartTarget> startTarget(Desk &desk);

/// NAME@MOTOR; empty if this firmware has no such register.
std::optional<drive::RegisterId> registerOf(const Desk &desk, const std::string &name);

/// A whole number that the board holds.
struct Digits16 {
    drive::RegisterId id = 0;
    std::int64_t value = 0;
};
/// Registers by name that this build has, in order; the others are left out.
Outcome<std::map<std::string, Digits16>> readDigits(
    Desk &desk, const std::vector<std::string> &names);

} // namespace cli
