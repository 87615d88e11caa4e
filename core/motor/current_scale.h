// The scale of a drive's currents from its measuring circuit, for boards that do not tell it.
// Source: the workbench of the motor control SDK: the converter sees the shunts' voltage amplified about its middle.
#pragma once

namespace motor {

struct CurrentSensing {
    double shunt_ohm = 0.0;
    double gain = 0.0; ///< of the amplifier, with its divider if it has one
    double reference_v = 0.0; ///< of the converter: its whole range
};

/// Current of the greatest reading, 32768 digits: reference / (2 shunt gain). 0 unless all are above 0.
double fullScaleCurrent_a(const CurrentSensing &sensing);

} // namespace motor
