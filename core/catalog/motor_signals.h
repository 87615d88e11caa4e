// What boards call the signals of a motor that formulas and vectors are made of, in their recordings.
#pragma once

#include <array>
#include <string_view>

namespace catalog {

/// The standard name, and that of firmware with names of its own. The first that is there is meant; those at one place
/// of several lists are of one board.
using SignalNames = std::array<std::string_view, 2>;

inline constexpr SignalNames kCurrentAlpha{"I_ALPHA_MEAS", "I_ALPHA"},
    kCurrentBeta{"I_BETA_MEAS", "I_BETA"}, kCurrentD{"I_D_MEAS", "I_D"},
    kCurrentQ{"I_Q_MEAS", "I_Q"}, kVoltageAlpha{"V_ALPHA", "U_ALPHA"},
    kVoltageBeta{"V_BETA", "U_BETA"}, kVoltageD{"V_D", "U_D"}, kVoltageQ{"V_Q", "U_Q"};
inline constexpr std::string_view kCurrentA = "I_A", kCurrentB = "I_B", kBusVoltage = "BUS_VOLTAGE";
/// Parts of the names of angles; an electrical one is meant if there are several.
inline constexpr std::string_view kElectricalAngle = "EL_ANGLE", kElectrical = "EL_";

} // namespace catalog
