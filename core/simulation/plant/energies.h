// Where the energy of a simulated drive went since it was switched on, in joules. Plain values.
//
//   supply     = source + board + bridge + (change of capacitor)
//   bridge     = inverter + copper + mechanical + (change of field)
//   mechanical = friction + load - driven + (change of kinetic and cogging)
// The first line of each pair of sides is summed up step by step by itself, so that a test can compare them.
#pragma once

namespace simulation {

struct Energies {
    // Sums.
    double supply_j = 0.0; ///< out of the ideal source
    double source_j = 0.0; ///< lost in the source's resistance
    double board_j = 0.0; ///< taken by the board itself
    double bridge_j = 0.0; ///< from the bus into the bridge; less when it returns
    double inverter_j = 0.0; ///< lost in switches and diodes
    double copper_j = 0.0;
    double mechanical_j = 0.0; ///< air gap torque times way
    double friction_j = 0.0; ///< viscous and dry friction of the motor
    double load_j = 0.0; ///< brake and fan
    double driven_j = 0.0; ///< put in by drive_nm
    // Stored now.
    double capacitor_j = 0.0;
    double field_j = 0.0; ///< of the currents; the magnets' own is not counted
    double kinetic_j = 0.0;
    double cogging_j = 0.0; ///< 0 at a detent
};

} // namespace simulation
