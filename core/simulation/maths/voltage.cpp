// Integers up to the compare registers; only the bridge of the model works with shares.
#include "simulation/maths/voltage.h"

#include <cmath>

namespace simulation {

std::int32_t squareRoot(std::int64_t value)
{
    // exact below 2^52: the square root of a double is correctly rounded
    return value <= 0 ? 0 : static_cast<std::int32_t>(std::sqrt(static_cast<double>(value)));
}

Circle circleOf(std::uint16_t max)
{
    const auto cut = static_cast<std::uint16_t>(std::min<std::int32_t>(max, kDigitsMax));
    return {cut, static_cast<std::uint16_t>(cut * 950 / 1000)};
}

Qd circleLimit(Qd v, Circle circle)
{
    const auto square = [](std::int64_t x) { return x * x; };
    if (square(v.q) + square(v.d) <= square(circle.max))
        return v;
    const std::int32_t d = std::clamp<std::int32_t>(v.d, -circle.maxD, circle.maxD);
    const std::int32_t room = squareRoot(square(circle.max) - square(d));
    const std::int32_t q = v.q < 0 ? -room : room;
    return {static_cast<std::int16_t>(q), static_cast<std::int16_t>(d)};
}

Compare modulate(AlphaBeta v, std::uint16_t period)
{
    constexpr std::int64_t kRoot3 = 56756; // 32768 sqrt(3)
    constexpr std::int64_t kInverseRoot3 = 18919; // 32768 / sqrt(3), to nearest
    // twice the phases, in digits with 15 more bits
    const std::int64_t alpha = std::int64_t{v.alpha} * 32768, side = kRoot3 * v.beta;
    const std::int64_t a = 2 * alpha, b = -alpha - side, c = -alpha + side;
    const std::int64_t middle = (std::max({a, b, c}) + std::min({a, b, c})) / 2;
    const auto count = [&](std::int64_t phase) {
        constexpr int kBits = 1 + 15 + 15 + 15; // of: twice, the 15 more, 1/sqrt(3), a digit
        const std::int64_t share = (phase - middle) * kInverseRoot3; // below 2^46, so all fits
        const std::int64_t counts =
            (share * period + (std::int64_t{period + 1} << (kBits - 1))) >> kBits;
        return static_cast<std::uint16_t>(std::clamp<std::int64_t>(counts, 0, period));
    };
    return {count(a), count(b), count(c)};
}

Duties dutiesOf(Compare compare, std::uint16_t period)
{
    const double each = period == 0 ? 0.0 : 1.0 / period;
    return {compare.a * each, compare.b * each, compare.c * each};
}

} // namespace simulation
