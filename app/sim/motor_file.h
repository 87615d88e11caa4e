// Motors from JSON files, and back. A file names what differs from a preset; it never changes a preset.
#pragma once

#include "base/result.h"
#include "simulation/plant/parameters.h"

#include <string>
#include <string_view>

namespace sim {

/// The machine that a file describes: {"preset": "pm24", "motor": {"rs_ohm": 0.5}, "load": {...}}; sections and names
/// are those of simulation::parameterTable(). What is not named is as in the preset, or as in the first one.
/// @return the machine, or one sentence with the file, the key and what is allowed there
Result<simulation::PlantParameters, std::string> readMotorFile(const std::string &path);

/// The same from text; `name` stands for the file in sentences.
Result<simulation::PlantParameters, std::string> readMotor(
    std::string_view json, const std::string &name);

} // namespace sim
