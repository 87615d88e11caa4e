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
constexpr Nanos kSecond = 1'000'000'000;

/// The nearest one, for every time that comes in seconds: that of a sample may lie a hair before it as a floating-point
/// number, and still means that sample.
inline Nanos toNanos(double seconds)
{
    return static_cast<Nanos>(std::llround(seconds * kNanosPerSecond));
}
inline double toSeconds(Nanos nanos) { return static_cast<double>(nanos) / kNanosPerSecond; }

/// Rate and origin of a board's tick counter.
struct TickBase {
    static constexpr std::int64_t kNanosPerKilosecond = 1'000'000'000'000;

    std::int64_t milliHz = 1000; ///< ticks in 1000 s, at least 1
    Nanos origin = 0; ///< of tick 0
    std::int64_t nanosPerTick = 1'000'000'000; ///< 0 if that is no whole number
    bool operator==(const TickBase &) const = default;

    static TickBase of(double tickHz, double originSeconds)
    {
        const double milliHz = std::round(tickHz * 1000.0);
        // Bounds keep the product in timeOf() inside 64 bits; no board has a rate beyond them
        // control loop.
        const bool sane = milliHz >= 1.0 && milliHz <= 9e9;
        const std::int64_t rate = sane ? static_cast<std::int64_t>(milliHz) : 1000;
        return {rate, toNanos(originSeconds),
            kNanosPerKilosecond % rate == 0 ? kNanosPerKilosecond / rate : 0};
    }

    /// Rounded to the nearest nanosecond; ticks below 0 are before the origin.
    Nanos timeOf(Tick tick) const
    {
        if (nanosPerTick != 0) // as of the usual control rates: four divisions less
            return origin + tick * nanosPerTick;
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
        return origin + whole * kNanosPerKilosecond + millis * 1'000'000 + nanos;
    }

    /// Nanoseconds a tick, for estimates.
    double tickNanos() const { return 1e12 / static_cast<double>(milliHz); }
};

} // namespace capture
