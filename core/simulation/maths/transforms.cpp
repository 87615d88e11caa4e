// 64-bit sums: two products of -32768 do not fit 32 bits, and no wrapping may hide in a transform.
#include "simulation/maths/transforms.h"

namespace simulation {

namespace {

constexpr std::int64_t kInverseRoot3 = 18918;

} // namespace

AlphaBeta clarke(Ab phases)
{
    const std::int64_t beta = (-kInverseRoot3 * phases.a - 2 * kInverseRoot3 * phases.b) >> 15;
    return {phases.a, saturateSymmetric(beta)};
}

Qd park(AlphaBeta v, Trig angle)
{
    const std::int64_t cosine = angle.cosine, sine = angle.sine;
    return {saturateSymmetric((v.alpha * cosine - v.beta * sine) >> 15),
        saturateSymmetric((v.alpha * sine + v.beta * cosine) >> 15)};
}

AlphaBeta reversePark(Qd v, Trig angle)
{
    const std::int64_t cosine = angle.cosine, sine = angle.sine;
    return {saturateSymmetric((v.q * cosine + v.d * sine) >> 15),
        saturateSymmetric((v.d * cosine - v.q * sine) >> 15)};
}

} // namespace simulation
