// What the board says about a motor and about itself, as far as gains and start-ups depend on it.
#pragma once

#include "analysis/motor_constants.h"
#include "commands.h"

namespace cli {

struct MotorFacts {
    analysis::MotorParameters motor; ///< 0: the board does not say
    drive::MotorLimits limits;
    double bus_v = 0.0; ///< nominal
    double ampsPerDigit = 0.0;
    double controlPeriod_s = 0.0, speedPeriod_s = 0.0;
    double inertia_kgm2 = 0.0; ///< as a profiler found it
};

/// What it does not say is 0.
Outcome<MotorFacts> readMotorFacts(Desk &desk, int motor);

/// NAME@MOTOR; empty if this firmware has no such register.
std::optional<drive::RegisterId> registerOf(const Desk &desk, const std::string &name, int motor);

/// A whole number that the board holds.
struct Digits16 {
    drive::RegisterId id = 0;
    std::int64_t value = 0;
};
/// Registers by name that this build has, in order; the others are left out.
Outcome<std::map<std::string, Digits16>> readDigits(
    Desk &desk, const std::vector<std::string> &names, int motor);

} // namespace cli
