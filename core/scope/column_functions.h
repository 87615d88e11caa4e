// The functions of a formula that look at more than one instant, and those that turn frames: each call in a formula is
// one object with its own memory. All are causal, so that appending samples never changes what was computed.
//
//   derivative(x)        to the sample before; nothing at the first sample after a gap
//   integral(x)          trapezoids; begins at 0 after each gap
//   lowpass(x, hz)       first order; begins at x
//   highpass(x, hz)      x - lowpass(x, hz)
//   median(x, n)         of the last n samples, or as many as there are since a gap
//   average(x, n)        likewise
//   unwrap(angle)        without the jumps of a turn; begins at the angle
//   clarke_alpha(a, b), clarke_beta(a, b)
//   park_d(alpha, beta, angle), park_q(alpha, beta, angle)
//       beta = -(a + 2 b) / sqrt 3; d = alpha sin + beta cos, q = alpha cos - beta sin: as MCSDK's firmware, so that
//       the results are those of the board's own registers
//   power(vd, id, vq, iq)   1.5 (vd id + vq iq): electrical power of peak values
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace scope {

enum class ColumnKind : std::uint8_t {
    Derivative,
    Integral,
    LowPass,
    HighPass,
    Median,
    Average,
    Unwrap,
    ClarkeAlpha,
    ClarkeBeta,
    ParkD,
    ParkQ,
    Power
};

struct ColumnFunctionInfo {
    std::string_view name;
    ColumnKind kind;
    std::uint8_t arguments;
    bool lastIsConstant; ///< the last argument is a number, not a signal
};

constexpr std::size_t kMostArguments = 4;
constexpr int kMostTaps = 1001; ///< of median and average

/// nullptr if there is none of that name.
const ColumnFunctionInfo *columnFunction(std::string_view name);
std::span<const ColumnFunctionInfo> columnFunctions();

class ColumnFunction {
public:
    virtual ~ColumnFunction() = default;
    /// @param arguments  finite; those that are no constants
    /// @param seconds    since the last call
    /// @param joined     nothing is missing since the last call; if false, forget what was before
    /// @return NaN where nothing is known
    virtual double step(std::span<const double> arguments, double seconds, bool joined) = 0;
};

struct ColumnSettings {
    double constant = 0.0; ///< frequency in Hz, or a number of samples
    double turn = 360.0; ///< of angles, in their unit
};

/// True if the constant makes sense for it: a frequency above 0, 1 to kMostTaps samples.
bool fits(ColumnKind kind, double constant);

std::unique_ptr<ColumnFunction> makeColumnFunction(ColumnKind kind, const ColumnSettings &settings);

} // namespace scope
