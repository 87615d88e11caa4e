// Gains as the firmware keeps them: a 16-bit numerator over a power of two, multiplied in 32 bits. Says what the
// rounding costs and how far the numbers are from overflowing; never touches a register.
// Source: the PI regulator of firmware 6.0 to 6.4 (`out = Kp * e >> kp_shift`, 32-bit product), whose *_DIV registers
// carry the exponent.
#pragma once

#include <cstdint>

namespace motor {

struct FixedPointGain {
    std::int32_t numerator = 0; ///< -32768 to 32767
    int exponent = 0; ///< 0 to kMaxExponent: the divisor is 2^exponent

    double value() const;
    bool operator==(const FixedPointGain &) const = default;
};

constexpr int kMaxExponent = 15; ///< what a *_DIV register takes
constexpr int kMaxNumerator = 32767;
/// Largest difference of two 16-bit digits: no error signal is larger.
constexpr double kMaxError_digits = 65535.0;

enum class FixedPointProblem : std::uint8_t {
    None,
    NotFinite, ///< there is no such gain
    NumeratorTooLarge, ///< does not fit 16 bits with this divisor: the largest was taken
    RoundsToZero, ///< the divisor is too small for so small a gain
    ProductTooLarge, ///< numerator times the largest error overflows 32 bits
};

struct Quantised {
    FixedPointGain gain;
    double error = 0.0; ///< (kept - wanted) / wanted
    double numeratorMargin = 0.0; ///< 32767 / |numerator|; below 1 it does not fit. Infinite for 0
    double productMargin = 0.0; ///< 2^31 / |numerator * largest error|; below 1 it overflows
    FixedPointProblem problem = FixedPointProblem::None;
};

/// The numerator nearest to `gain` over 2^exponent.
/// @param exponent  clipped to 0..kMaxExponent
/// @param maxError_digits  largest error that the regulator may see, > 0
Quantised quantise(double gain, int exponent, double maxError_digits = kMaxError_digits);

/// The same with the largest divisor that keeps numerator and product in range: the smallest rounding.
Quantised quantiseFinely(double gain, double maxError_digits = kMaxError_digits);

} // namespace motor
