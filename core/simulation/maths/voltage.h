// From the voltage that the current loops ask for to the three outputs of the bridge: circle limitation, modulation.
// Pure functions. A voltage digit here is 1/32768 of bus / sqrt(3), the largest phase amplitude without overmodulation.
#pragma once

#include "simulation/maths/fixed_point.h"

namespace simulation {

/// How long a voltage vector may be, and how much of it the d axis may claim.
struct Circle {
    std::uint16_t max = 32767; ///< at most 32767
    std::uint16_t maxD = 31128; ///< 95 % of max, as ST's library has it
};

/// The circle of a maximum modulus; d may take 95 % of it, cut to a whole digit. Moduli past 32767 are cut.
Circle circleOf(std::uint16_t max);

/// `v` if it is not longer than circle.max; otherwise d goes first: it keeps its value up to circle.maxD, and q keeps
/// its sign and gets the length that is left (square root, cut to a whole digit). The result is never longer than max.
Qd circleLimit(Qd v, Circle circle);

/// Counts of the timer at the three outputs, 0..period: how long the upper switch is on.
struct Compare {
    std::uint16_t a = 0, b = 0, c = 0;
    bool operator==(const Compare &) const = default;
};

/// Shares of the control period, 0..1.
struct Duties {
    double a = 0.5, b = 0.5, c = 0.5;
};

/// Space vector modulation of a centred timer that counts to `period` (carrier rate = clock / 2 period): the phases
/// a = alpha, b = (-alpha - sqrt(3) beta) / 2, c = (-alpha + sqrt(3) beta) / 2, moved together so that the highest and
/// the lowest are equally far from half. Rounded to the nearest count; beyond the hexagon it is cut at 0 and period.
Compare modulate(AlphaBeta v, std::uint16_t period);

/// The same as shares of the period, in steps of one count.
Duties dutiesOf(Compare compare, std::uint16_t period);

} // namespace simulation
