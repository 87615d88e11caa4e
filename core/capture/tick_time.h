// Where a tick lies on the session's time axis, in whole nanoseconds: integer arithmetic, so that
// equal ticks give equal times however they are reached, and a file can print them exactly.
#pragma once

#include "capture/sample_block.h"

#include <cmath>
#include <cstdint>

namespace capture {

/// Nanoseconds on the session's axis; 292 years either way.
using Nanos = std::int64_t;

constexpr double kNanosPerSecond = 1e9;

inline Nanos toNanos(double seconds)
{
    return static_cast<Nanos>(std::llround(seconds * kNanosPerSecond));
}
inline double toSeconds(Nanos nanos) { return static_cast<double>(nanos) / kNanosPerSecond; }

/// Rate and origin of a board's tick counter.
struct TickBase {
    std::int64_t milliHz = 1000; ///< ticks in 1000 s, at least 1
    Nanos origin = 0; ///< of tick 0
    std::int64_t wholeNanos = 1'000'000'000; ///< a tick; 0: it is no whole number of them
    bool operator==(const TickBase &) const = default;

    static TickBase of(double tickHz, double originSeconds)
    {
        const double milliHz = std::round(tickHz * 1000.0);
        // Bounds keep the product in timeOf() inside 64 bits; a rate beyond them is nobody's
        // control loop.
        const bool sane = milliHz >= 1.0 && milliHz <= 9e9;
        const std::int64_t rate = sane ? static_cast<std::int64_t>(milliHz) : 1000;
        return {rate, toNanos(originSeconds), kPicoKilo % rate == 0 ? kPicoKilo / rate : 0};
    }

    /// Rounded to the nearest nanosecond; ticks below 0 are before the origin.
    Nanos timeOf(Tick tick) const
    {
        if (wholeNanos != 0) // as of the usual control rates: four divisions less
            return origin + tick * wholeNanos;
        // tick / (milliHz / 1000) s, split into kilo-seconds and the rest so that no product
        // overflows.
        std::int64_t whole = tick / milliHz;
        std::int64_t rest = tick % milliHz;
        if (rest < 0) {
            rest += milliHz;
            whole -= 1;
        }
        const std::int64_t millis = rest * 1'000'000 / milliHz;
        const std::int64_t left = rest * 1'000'000 % milliHz;
        const std::int64_t nanos = (left * 1'000'000 + milliHz / 2) / milliHz;
        return origin + whole * kPicoKilo + millis * 1'000'000 + nanos;
    }

    static constexpr std::int64_t kPicoKilo = 1'000'000'000'000; ///< nanoseconds in 1000 s

    /// Nanoseconds a tick, for estimates.
    double tickNanos() const { return 1e12 / static_cast<double>(milliHz); }
};

} // namespace capture
