// The tables are computed by the compiler from the power series, so that no library's sin decides a digit. Transforms
// have 64-bit sums: two products of -32768 do not fit 32 bits, and no wrapping may hide in a transform.
#include "simulation/maths/transforms.h"

#include <array>
#include <cstddef>
#include <numbers>

namespace simulation {

namespace {

constexpr int kStepBits = 6; ///< 64 angles from one table entry to the next
constexpr std::size_t kQuarterEntries = 256;

constexpr double sineSeries(double x)
{
    double term = x, sum = x;
    for (int n = 1; n < 15; ++n) {
        term *= -x * x / ((2.0 * n) * (2.0 * n + 1.0));
        sum += term;
    }
    return sum;
}

/// Of what is not negative; std::lround is not for the compiler to call.
constexpr std::int64_t toNearest(double value)
{
    const auto whole = static_cast<std::int64_t>(value);
    return value - static_cast<double>(whole) < 0.5 ? whole : whole + 1;
}

constexpr auto kQuarter = [] {
    std::array<std::int16_t, kQuarterEntries + 1> table{};
    for (std::size_t i = 0; i <= kQuarterEntries; ++i) {
        const double x = static_cast<double>(i) * (std::numbers::pi / 2.0 / kQuarterEntries);
        table[i] = saturate16(toNearest(32768.0 * sineSeries(x)));
    }
    return table;
}();

/// Of 0..16384, a quarter turn.
std::int16_t sineOfQuarter(std::uint32_t angle)
{
    const std::size_t index = angle >> kStepBits;
    const std::int32_t rest = static_cast<std::int32_t>(angle & ((1U << kStepBits) - 1U));
    const std::int32_t low = kQuarter[index];
    if (rest == 0)
        return kQuarter[index];
    const std::int32_t half = 1 << (kStepBits - 1);
    return static_cast<std::int16_t>(
        low + (((kQuarter[index + 1] - low) * rest + half) >> kStepBits));
}

std::int16_t sine(std::uint16_t angle)
{
    const std::uint32_t within = angle & 0x3FFFU;
    const bool falling = (angle & 0x4000U) != 0;
    const std::int16_t size = sineOfQuarter(falling ? 0x4000U - within : within);
    return (angle & 0x8000U) != 0 ? static_cast<std::int16_t>(-size) : size;
}

constexpr int kCordicSteps = 18;

constexpr double arcTangentSeries(double x) // 0 to 0.5
{
    double power = x, sum = x;
    for (int n = 1; n < 40; ++n) {
        power *= -x * x;
        sum += power / (2.0 * n + 1.0);
    }
    return sum;
}

/// Arc tangents of 2^-i, 2^32 a turn.
constexpr auto kArcTangents = [] {
    std::array<std::uint32_t, kCordicSteps> table{};
    table[0] = 1U << 29U;
    double x = 0.5;
    for (std::size_t i = 1; i < kCordicSteps; ++i, x /= 2.0)
        table[i] = static_cast<std::uint32_t>(
            toNearest(arcTangentSeries(x) * (4294967296.0 / (2.0 * std::numbers::pi))));
    return table;
}();

constexpr std::int64_t kInverseRoot3 = 18918;

} // namespace

Trig trig(std::int16_t angle)
{
    const auto a = static_cast<std::uint16_t>(angle);
    return {sine(static_cast<std::uint16_t>(a + 0x4000U)), sine(a)};
}

std::int16_t angleOf(std::int16_t x, std::int16_t y)
{
    if (x == 0 && y == 0)
        return 0;
    // 14 more bits leave room for the gain of 1.65 and the diagonal: 32768 * 2^14 * 2.33 < 2^31
    std::int32_t u = x * (1 << 14), v = y * (1 << 14);
    std::uint32_t angle = 0;
    if (u < 0) {
        u = -u;
        v = -v;
        angle = 1U << 31U;
    }
    for (std::size_t i = 0; i < kCordicSteps; ++i) {
        const std::int32_t du = v >> i, dv = u >> i;
        if (v > 0) {
            u += du;
            v -= dv;
            angle += kArcTangents[i];
        } else {
            u -= du;
            v += dv;
            angle -= kArcTangents[i];
        }
    }
    return static_cast<std::int16_t>(static_cast<std::uint16_t>((angle + 0x8000U) >> 16U));
}

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
