#include "motor/fixed_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace motor {

namespace {

constexpr double kProductLimit = 2147483648.0; // 2^31

double marginOf(double limit, double size)
{
    return size > 0.0 ? limit / size : std::numeric_limits<double>::infinity();
}

} // namespace

double FixedPointGain::value() const
{
    return std::ldexp(static_cast<double>(numerator), -exponent);
}

Quantised quantise(double gain, int exponent, double maxError_digits)
{
    Quantised result;
    result.gain.exponent = std::clamp(exponent, 0, kMaxExponent);
    if (!std::isfinite(gain)) {
        result.problem = FixedPointProblem::NotFinite;
        return result;
    }
    const double wanted = std::round(std::ldexp(gain, result.gain.exponent));
    const double kept = std::clamp(wanted, -double{kMaxNumerator}, double{kMaxNumerator});
    result.gain.numerator = static_cast<std::int32_t>(kept);
    result.error = gain == 0.0 ? 0.0 : (result.gain.value() - gain) / gain;
    result.numeratorMargin = marginOf(kMaxNumerator, std::abs(wanted));
    result.productMargin = marginOf(kProductLimit, std::abs(wanted) * maxError_digits);
    if (kept != wanted)
        result.problem = FixedPointProblem::NumeratorTooLarge;
    else if (result.productMargin <= 1.0)
        result.problem = FixedPointProblem::ProductTooLarge;
    else if (kept == 0.0 && gain != 0.0)
        result.problem = FixedPointProblem::RoundsToZero;
    return result;
}

Quantised quantiseFinely(double gain, double maxError_digits)
{
    Quantised result = quantise(gain, kMaxExponent, maxError_digits);
    for (int exponent = kMaxExponent - 1; exponent >= 0; --exponent) {
        if (result.problem != FixedPointProblem::NumeratorTooLarge
            && result.problem != FixedPointProblem::ProductTooLarge)
            break;
        result = quantise(gain, exponent, maxError_digits);
    }
    return result;
}

} // namespace motor
