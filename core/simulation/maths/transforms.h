// Clarke, Park and its reverse in 16 bits, and the trigonometry of their angles. Pure functions; what the transforms
// give saturates to -32767..32767 and never wraps. Source: features 6.2 for the arithmetic, fixed_point.h for the axes.
//
// Sine, cosine and arc tangent are as precise as the CORDIC unit of the processors that ST's library uses where there
// is one. (Its table for the others knows 1024 angles a turn: not modelled.)
#pragma once

#include "simulation/maths/fixed_point.h"

namespace simulation {

/// Cosine and sine of `angle`, 65536 a turn. From 257 values a quarter, min(32767, 32768 sin rounded to nearest), and
/// between them a straight line, rounded to nearest with halves towards plus infinity: within 1.5 digits of 32768 times
/// the true value (1.0 itself is cut to 32767). Exact symmetry: sin(-x) = -sin(x), cos(x) = sin(x + quarter turn).
Trig trig(std::int16_t angle);

/// The angle of the vector (x, y), 65536 a turn, within 1 digit where its length is 2000 or more; 0 for (0, 0).
/// Integer CORDIC in 32 bits, 18 steps; no length overflows.
std::int16_t angleOf(std::int16_t x, std::int16_t y);

/// Phases to alpha and beta: alpha = a, beta = (-18918 a - 2 * 18918 b) >> 15, where 18918 = 32768 / sqrt(3), cut.
AlphaBeta clarke(Ab phases);

/// To rotor coordinates: q = (alpha cos - beta sin) >> 15, d = (alpha sin + beta cos) >> 15.
Qd park(AlphaBeta v, Trig angle);

/// Back: alpha = (q cos + d sin) >> 15, beta = (d cos - q sin) >> 15.
AlphaBeta reversePark(Qd v, Trig angle);

} // namespace simulation
