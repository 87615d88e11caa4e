// Every figure of a simulated machine with its name, its bounds and its meaning: for code that reads parameters from a
// file, lists them or checks them. One row a member of parameters.h; the unit is the end of the name.
#pragma once

#include "simulation/plant/parameters.h"

#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace simulation {

struct ParameterInfo {
    using Slot = std::variant<double *, int *, bool *, std::string *>;

    std::string_view section; ///< motor, sensors, inverter, load
    std::string_view name; ///< of the member
    Slot (*slot)(PlantParameters &); ///< where it is
    double least, most; ///< both allowed; of a text: bytes
    std::string_view meaning;
};

/// What stands there; of a text its bytes, of yes and no 1 and 0.
double numberAt(const ParameterInfo::Slot &slot);

/// All of them, section by section.
std::span<const ParameterInfo> parameterTable();

/// Whether the value is within the row's bounds; not-a-number never is.
bool withinBounds(const ParameterInfo &info, const PlantParameters &parameters);

} // namespace simulation
