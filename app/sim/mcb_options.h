// What rotorscope-sim mcb takes beside the options of every board with a motor.
#pragma once

#include "options.h"

namespace sim {

/// The firmware that a name stands for; a sentence if there is none.
std::optional<std::string> readServoProfile(std::string_view name, simulation::ServoOptions &servo);

/// Adds the faults of a list like "flip:100,reset".
std::optional<std::string> readMcbFaults(
    std::string_view list, std::vector<simulation::McbFaultChoice> &faults);

} // namespace sim
