// The bounds of an experiment that are known before it begins: the user agrees to them, and its runner holds the motor
// to the same ones. What only a board can tell, its bus voltage and its temperature, is left to the runner.
#pragma once

#include "lab/envelope.h"
#include "lab/experiment.h"

namespace lab {

/// Of two bounds, of which 0 is an unknown one.
double lowerKnown(double one, double other);
/// From the first command to the last.
/// @param before_rpm  the set-point of a motor that runs, which passes it on its way back; 0: it stands
Caps capsOf(const Experiment &experiment, double before_rpm);

/// What the board's or the motor's own current is multiplied by: a current loop overshoots there.
inline constexpr double kCurrentAboveBoard = 1.25;
/// Which current the bound of it follows from.
enum class CurrentBound : std::uint8_t {
    None, ///< there is no bound
    Nominal, ///< the motor's, times kCurrentAboveBoard
    Board, ///< the greatest that the board tells, times the same
    User,
};
CurrentBound currentBoundOf(const Experiment &experiment);

/// Whatever the plan: what the board tells, and never more than the user allows.
double allowedRpm(const Experiment &experiment);

/// Whether `wanted` is within what was agreed to.
bool covers(const Caps &agreed, const Caps &wanted);

/// What the user agrees to: what is done, within which bounds, for how long, and what is written for it.
struct Agreement {
    std::size_t kind = 0; ///< of the plan
    bool flux = false; ///< with currents along the magnets
    Caps caps;
    milliseconds length{};
    std::vector<drive::RegisterWrite> lent = {};
    double leastDegrees = 0.0, mostDegrees = 0.0; ///< that a shaft is moved by, from where it rests
};
Agreement agreementTo(const Experiment &experiment, double before_rpm);
/// What is borrowed has to be the same, or nothing.
bool covers(const Agreement &agreed, const Agreement &wanted);

} // namespace lab
