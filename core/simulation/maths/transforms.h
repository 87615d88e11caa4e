// Clarke, Park and its reverse in 16 bits. Pure functions; results saturate to -32767..32767 and never wrap.
// Source: features 6.2 for the arithmetic, fixed_point.h for the axes.
#pragma once

#include "simulation/maths/fixed_point.h"

namespace simulation {

/// Phases to alpha and beta: alpha = a, beta = (-18918 a - 2 * 18918 b) >> 15, where 18918 = 32768 / sqrt(3), cut.
AlphaBeta clarke(Ab phases);

/// To rotor coordinates: q = (alpha cos - beta sin) >> 15, d = (alpha sin + beta cos) >> 15.
Qd park(AlphaBeta v, Trig angle);

/// Back: alpha = (q cos + d sin) >> 15, beta = (d cos - q sin) >> 15.
AlphaBeta reversePark(Qd v, Trig angle);

} // namespace simulation
