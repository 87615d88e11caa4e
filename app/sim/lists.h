// What rotorscope-sim can be asked for, as lists for people: a name and a line each, the default first.
#pragma once

#include <string>

namespace sim {

std::string profileList();
std::string optionList();
std::string motorList();
std::string liarList();

} // namespace sim
