// Time as core knows it: an argument. Nothing in core reads a clock; the session passes its one reading of a
// monotonic clock, tests pass whatever instant they want to be in.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

using Duration = std::chrono::nanoseconds;

/// Names the epoch only: "some monotonic clock". It has no now() on purpose.
struct VirtualClock {
    using duration = Duration;
    using rep = duration::rep;
    using period = duration::period;
    using time_point = std::chrono::time_point<VirtualClock, Duration>;
    static constexpr bool is_steady = true;
};

using TimePoint = VirtualClock::time_point;

/// Seconds as a floating-point number, for display and for arithmetic with rates.
constexpr double toSeconds(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

/// The nearest whole nanosecond to `seconds`.
constexpr Duration fromSeconds(double seconds)
{
    return Duration(static_cast<Duration::rep>(seconds * 1e9 + (seconds < 0 ? -0.5 : 0.5)));
}

/// Makes `due` the earlier one of both; empty: never.
constexpr void earliest(std::optional<TimePoint> &due, std::optional<TimePoint> other)
{
    if (other && (!due || *other < *due))
        due = other;
}

/// How long `bytes` take on an asynchronous line with 10 bits a byte (1 start, 8 data, 1 stop).
constexpr Duration wireTime(std::size_t bytes, std::uint32_t baud)
{
    return Duration(static_cast<Duration::rep>(bytes * 10 * 1'000'000'000ULL / baud));
}
