// The parts that every trigger is made of: half-lines of values, and the crossing of a level with hysteresis. They
// work on stored codes or on shown values alike, and can say of a whole block that nothing in it would move them.
#pragma once

#include "capture/channel.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace scope {

/// All values from `bound` on, upwards or downwards. For codes the bound was found by asking the channel's own scale
/// for each code, so that a comparison of codes decides exactly as one of shown values.
template <class T>
struct Half {
    bool up = true;
    T bound{};

    bool holds(T value) const { return up ? value >= bound : value <= bound; }
    /// No value of [min, max] is in it.
    bool misses(T min, T max) const { return up ? max < bound : min > bound; }
};

/// The codes of which `holds(shown value)` is true; it must be monotone. The bound is a code of 16 bits, or the one
/// above all of them where no code is in it.
template <class Holds>
Half<std::int32_t> halfOfCodes(const capture::Channel &channel, Holds holds)
{
    const auto of = [&](std::int32_t code) { return holds(channel.toShown(double(code))); };
    std::int32_t low = std::numeric_limits<std::int16_t>::min();
    std::int32_t high = std::numeric_limits<std::int16_t>::max();
    const bool atLow = of(low);
    const bool atHigh = of(high);
    if (atLow == atHigh)
        return atLow ? Half<std::int32_t>{false, high} : Half<std::int32_t>{true, high + 1};
    while (high - low > 1) {
        const std::int32_t middle = low + (high - low) / 2;
        (of(middle) == atLow ? low : high) = middle;
    }
    return {atHigh, atHigh ? high : low};
}

/// The half-lines of a channel's values as they are compared, by the type of value.
template <class T>
struct Halves;

template <>
struct Halves<std::int32_t> {
    const capture::Channel &channel;
    Half<std::int32_t> atLeast(double level) const
    {
        return halfOfCodes(channel, [=](double shown) { return shown >= level; });
    }
    Half<std::int32_t> atMost(double level) const
    {
        return halfOfCodes(channel, [=](double shown) { return shown <= level; });
    }
    Half<std::int32_t> above(double level) const
    {
        return halfOfCodes(channel, [=](double shown) { return shown > level; });
    }
    Half<std::int32_t> below(double level) const
    {
        return halfOfCodes(channel, [=](double shown) { return shown < level; });
    }
};

template <>
struct Halves<double> {
    const capture::Channel &channel;
    static constexpr double kEnd = std::numeric_limits<double>::infinity();
    Half<double> atLeast(double level) const { return {true, level}; }
    Half<double> atMost(double level) const { return {false, level}; }
    Half<double> above(double level) const { return {true, std::nextafter(level, kEnd)}; }
    Half<double> below(double level) const { return {false, std::nextafter(level, -kEnd)}; }
};

/// One direction of one level: armed beyond the hysteresis, fires at the level.
template <class T>
struct Crossing {
    double level = 0.0;
    Half<T> arm;
    Half<T> fire;
    bool armed = false;

    static Crossing upwards(const Halves<T> &halves, double level, double hysteresis)
    {
        return {level, halves.below(level - hysteresis), halves.atLeast(level)};
    }
    static Crossing downwards(const Halves<T> &halves, double level, double hysteresis)
    {
        return {level, halves.above(level + hysteresis), halves.atMost(level)};
    }

    /// True if this sample crosses the level.
    bool step(T value)
    {
        if (!armed) {
            armed = arm.holds(value);
            return false;
        }
        armed = !fire.holds(value);
        return !armed;
    }
    /// Which samples would change it; see trigger_machines.h.
    template <class In>
    std::uint32_t moves(In in) const
    {
        return in(armed ? fire : arm);
    }
};

} // namespace scope
