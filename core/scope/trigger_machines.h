// One small machine a kind of trigger: samples go in one by one, hits come out. They own no samples and no position;
// trigger_search.cpp feeds them and passes over blocks that leave them quiet.
//
// Each machine has
//   begin(time)         nothing is known before the next sample, which is at `time`
//   wrapped()           the next sample is the same angle, counted from the other end
//   step(at, value)     the hit that this sample makes, if any
//   moves(in)           which samples would change it or make a hit. in(half) says which of them lie in a half-line, a
//                       bit each
//   due()               when it fires by itself if nothing comes before
#pragma once

#include "scope/level_crossing.h"
#include "scope/trigger_search.h"

#include <utility>

namespace scope {

/// A sample as a machine sees it; `Reader` knows its time and its neighbours.
template <class Reader>
struct At {
    Reader &reader;
    Index index;

    Nanos time() const { return reader.timeOf(index); }
    TriggerHit hit() const { return {time(), index, 1.0}; }
    /// Where the level was crossed on the way from the sample before to this one.
    TriggerHit crossing(double level) const { return reader.crossing(index, level); }
    TriggerHit hitAt(Nanos when) const { return reader.between(index, when); }
    bool reached(Nanos when) const { return reader.reached(index, when); }
    bool counts() const { return reader.counts(index); }
};

using MaybeHit = std::optional<TriggerHit>;

/// What most machines have in common.
struct PlainMachine {
    static constexpr bool kForgetful = false; ///< true: samples that may not fire need not be seen
    std::optional<Nanos> due() const { return std::nullopt; }
};

/// Edges of one level in one or both directions.
template <class T>
struct Edges {
    Slope slope = Slope::Rising;
    Crossing<T> rising;
    Crossing<T> falling;

    Edges(const Halves<T> &halves, Slope which, double level, double hysteresis)
        : slope(which)
        , rising(Crossing<T>::upwards(halves, level, hysteresis))
        , falling(Crossing<T>::downwards(halves, level, hysteresis))
    {
    }
    Edges(const Halves<T> &halves, const EdgeTrigger &edge)
        : Edges(halves, edge.slope, edge.level, edge.hysteresis)
    {
    }
    double level() const { return rising.level; }
    bool step(T value)
    {
        const bool rose = slope != Slope::Falling && rising.step(value);
        const bool fell = slope != Slope::Rising && falling.step(value);
        return rose || fell;
    }
    template <class In>
    std::uint32_t moves(In in) const
    {
        return (slope == Slope::Falling ? 0 : rising.moves(in))
            | (slope == Slope::Rising ? 0 : falling.moves(in));
    }
    void disarm() { rising.armed = falling.armed = false; }
};

template <class T>
struct EdgeMachine : PlainMachine {
    Edges<T> edges;

    EdgeMachine(const Halves<T> &halves, const EdgeTrigger &edge)
        : edges(halves, edge)
    {
    }
    void begin(Nanos /*time*/) { edges.disarm(); }
    void wrapped() { edges.disarm(); }
    template <class Reader>
    MaybeHit step(const At<Reader> &at, T value)
    {
        return edges.step(value) && at.counts() ? MaybeHit(at.crossing(edges.level()))
                                                : std::nullopt;
    }
    template <class In>
    std::uint32_t moves(In in) const
    {
        return edges.moves(in);
    }
};

template <class T>
struct LevelMachine : PlainMachine {
    static constexpr bool kForgetful = true;
    Half<T> side;

    LevelMachine(const Halves<T> &halves, const LevelTrigger &level)
        : side(level.side == LevelTrigger::Side::AtOrAbove ? halves.atLeast(level.level)
                                                           : halves.atMost(level.level))
    {
    }
    void begin(Nanos /*time*/) { }
    void wrapped() { }
    template <class Reader>
    MaybeHit step(const At<Reader> &at, T value) const
    {
        return side.holds(value) ? MaybeHit(at.hit()) : std::nullopt;
    }
    template <class In>
    std::uint32_t moves(In in) const
    {
        return in(side);
    }
};

template <class T>
struct LeavingMachine : PlainMachine {
    double low;
    double high;
    Half<T> armLow;
    Half<T> armHigh;
    Half<T> under;
    Half<T> over;
    bool armed = false;

    LeavingMachine(const Halves<T> &halves, const WindowTrigger &window)
        : low(window.low)
        , high(window.high)
        , armLow(halves.atLeast(window.low + window.hysteresis))
        , armHigh(halves.atMost(window.high - window.hysteresis))
        , under(halves.below(window.low))
        , over(halves.above(window.high))
    {
    }
    void begin(Nanos /*time*/) { armed = false; }
    void wrapped() { armed = false; }
    template <class Reader>
    MaybeHit step(const At<Reader> &at, T value)
    {
        if (!armed) {
            armed = armLow.holds(value) && armHigh.holds(value);
            return std::nullopt;
        }
        const bool isOver = over.holds(value);
        if (!isOver && !under.holds(value))
            return std::nullopt;
        armed = false;
        return at.crossing(isOver ? high : low);
    }
    template <class In>
    std::uint32_t moves(In in) const
    {
        return armed ? in(over) | in(under) : in(armLow)&in(armHigh);
    }
};

template <class T>
struct EnteringMachine : PlainMachine {
    double low;
    double high;
    Half<T> armUnder;
    Half<T> armOver;
    Half<T> atLow;
    Half<T> atHigh;
    enum class From : std::uint8_t { Nowhere, Under, Over } from = From::Nowhere;

    EnteringMachine(const Halves<T> &halves, const WindowTrigger &window)
        : low(window.low)
        , high(window.high)
        , armUnder(halves.below(window.low - window.hysteresis))
        , armOver(halves.above(window.high + window.hysteresis))
        , atLow(halves.atLeast(window.low))
        , atHigh(halves.atMost(window.high))
    {
    }
    void begin(Nanos /*time*/) { from = From::Nowhere; }
    void wrapped() { from = From::Nowhere; }
    template <class Reader>
    MaybeHit step(const At<Reader> &at, T value)
    {
        if (from != From::Nowhere && atLow.holds(value) && atHigh.holds(value)) {
            const double bound = from == From::Under ? low : high;
            from = From::Nowhere;
            return at.crossing(bound);
        }
        // From side to side without a sample inside is no entry, but it comes from there now.
        if (armUnder.holds(value) || (from == From::Over && !atLow.holds(value)))
            from = From::Under;
        else if (armOver.holds(value) || (from == From::Under && !atHigh.holds(value)))
            from = From::Over;
        return std::nullopt;
    }
    template <class In>
    std::uint32_t moves(In in) const
    {
        if (from == From::Nowhere)
            return in(armUnder) | in(armOver);
        return in(from == From::Under ? atLow : atHigh);
    }
};

template <class T>
struct PulseMachine : PlainMachine {
    Crossing<T> first;
    Crossing<T> second;
    DurationTest width;
    std::optional<Nanos> started;

    PulseMachine(const Halves<T> &halves, const PulseTrigger &pulse)
        : first(Crossing<T>::upwards(halves, pulse.level, pulse.hysteresis))
        , second(Crossing<T>::downwards(halves, pulse.level, pulse.hysteresis))
        , width(pulse.width)
    {
        if (pulse.polarity == PulseTrigger::Polarity::Negative)
            std::swap(first, second);
    }
    void begin(Nanos /*time*/)
    {
        wrapped();
        started.reset();
    }
    void wrapped() { first.armed = second.armed = false; }
    template <class Reader>
    MaybeHit step(const At<Reader> &at, T value)
    {
        if (first.step(value))
            started = at.crossing(first.level).time;
        if (!second.step(value) || !started)
            return std::nullopt;
        const TriggerHit end = at.crossing(second.level);
        const bool wanted = width.holds(end.time - *started);
        started.reset();
        return wanted ? MaybeHit(end) : std::nullopt;
    }
    template <class In>
    std::uint32_t moves(In in) const
    {
        return first.moves(in) | second.moves(in);
    }
};

/// One direction of a slew: from the crossing of the first level to the second one.
template <class T>
struct Ramp {
    Crossing<T> start;
    Half<T> arrived;
    double last = 0.0;
    std::optional<Nanos> started;

    template <class Reader>
    MaybeHit step(const At<Reader> &at, T value, const DurationTest &test)
    {
        if (start.step(value))
            started = at.crossing(start.level).time;
        if (start.armed) // it went back
            started.reset();
        if (!started || !arrived.holds(value))
            return std::nullopt;
        const TriggerHit end = at.crossing(last);
        const bool wanted = test.holds(end.time - *started);
        started.reset();
        return wanted ? MaybeHit(end) : std::nullopt;
    }
    template <class In>
    std::uint32_t moves(In in) const
    {
        return start.moves(in) | (started ? in(arrived) : 0);
    }
    void begin()
    {
        start.armed = false;
        started.reset();
    }
};

template <class T>
struct SlewMachine : PlainMachine {
    Slope slope;
    DurationTest test;
    Ramp<T> rise;
    Ramp<T> fall;

    SlewMachine(const Halves<T> &halves, const SlewTrigger &slew)
        : slope(slew.slope)
        , test(slew.time)
        , rise{Crossing<T>::upwards(halves, slew.low, slew.hysteresis), halves.atLeast(slew.high),
              slew.high, {}}
        , fall{Crossing<T>::downwards(halves, slew.high, slew.hysteresis), halves.atMost(slew.low),
              slew.low, {}}
    {
    }
    void begin(Nanos /*time*/)
    {
        rise.begin();
        fall.begin();
    }
    void wrapped() { begin(0); }
    template <class Reader>
    MaybeHit step(const At<Reader> &at, T value)
    {
        MaybeHit hit;
        if (slope != Slope::Falling)
            hit = rise.step(at, value, test);
        if (slope != Slope::Rising) {
            const MaybeHit fell = fall.step(at, value, test);
            hit = hit ? hit : fell; // one sample cannot end both
        }
        return hit;
    }
    template <class In>
    std::uint32_t moves(In in) const
    {
        return (slope == Slope::Falling ? 0 : rise.moves(in))
            | (slope == Slope::Rising ? 0 : fall.moves(in));
    }
};

template <class T>
struct DropoutMachine : PlainMachine {
    Edges<T> edges;
    Nanos time;
    std::optional<Nanos> dueAt;

    DropoutMachine(const Halves<T> &halves, const DropoutTrigger &dropout)
        : edges(halves, dropout.edge)
        , time(dropout.time)
    {
    }
    void begin(Nanos /*time*/)
    {
        edges.disarm();
        dueAt.reset();
    }
    void wrapped() { edges.disarm(); }
    template <class Reader>
    MaybeHit step(const At<Reader> &at, T value)
    {
        MaybeHit edge;
        if (edges.step(value))
            edge = at.crossing(edges.level());
        MaybeHit hit;
        if (dueAt && at.reached(*dueAt) && (!edge || edge->time >= *dueAt)) {
            hit = at.hitAt(*dueAt);
            dueAt.reset();
        }
        if (edge)
            dueAt = edge->time + time;
        return hit;
    }
    template <class In>
    std::uint32_t moves(In in) const
    {
        return edges.moves(in);
    }
    std::optional<Nanos> due() const { return dueAt; }
};

template <class T>
struct NthEdgeMachine : PlainMachine {
    Edges<T> edges;
    std::uint32_t count;
    Nanos idle;
    std::uint32_t seen = 0; ///< edges of this burst
    bool counting = false;
    Nanos last = 0; ///< edge, or where the samples begin

    NthEdgeMachine(const Halves<T> &halves, const NthEdgeTrigger &nth)
        : edges(halves, nth.edge)
        , count(nth.count)
        , idle(nth.idle)
    {
    }
    void begin(Nanos time)
    {
        edges.disarm();
        seen = 0;
        counting = idle == 0;
        last = time;
    }
    void wrapped() { edges.disarm(); }
    template <class Reader>
    MaybeHit step(const At<Reader> &at, T value)
    {
        if (!edges.step(value))
            return std::nullopt;
        const TriggerHit edge = at.crossing(edges.level());
        if (idle > 0 && edge.time - last >= idle) {
            counting = true;
            seen = 0;
        }
        last = edge.time;
        if (!counting || ++seen < count)
            return std::nullopt;
        seen = 0;
        counting = idle == 0;
        return edge;
    }
    template <class In>
    std::uint32_t moves(In in) const
    {
        return edges.moves(in);
    }
};

} // namespace scope
