// What a trigger waits for, in the unit of the channel it watches. Values only: trigger_search.h looks for it.
//
// A level counts as crossed upwards when a sample is at or above it, after one that was below `level - hysteresis`;
// downwards the other way round. Nothing is known across a gap, so a gap is never an edge, and ends every pulse,
// count and pause. Words as on bench scopes.
#pragma once

#include "capture/channel.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <variant>

namespace scope {

using capture::Index;
using capture::Nanos;

enum class Slope : std::uint8_t { Rising, Falling, Either };

/// Which durations count: from `least` to `most` (both included), or with `Outside` all others.
struct DurationTest {
    Nanos least = 0;
    Nanos most = std::numeric_limits<Nanos>::max();
    enum class Where : std::uint8_t { Inside, Outside } where = Where::Inside;
    bool holds(Nanos duration) const
    {
        return (duration >= least && duration <= most) == (where == Where::Inside);
    }
};

struct EdgeTrigger {
    Slope slope = Slope::Rising;
    double level = 0.0;
    double hysteresis = 0.0;
};

/// Every sample on that side of the level: needs no crossing, so it fires again as soon as it may.
struct LevelTrigger {
    enum class Side : std::uint8_t { AtOrAbove, AtOrBelow } side = Side::AtOrAbove;
    double level = 0.0;
};

/// The value leaves [low, high], or comes back into it.
struct WindowTrigger {
    enum class When : std::uint8_t { Leaves, Enters } when = When::Leaves;
    double low = 0.0;
    double high = 0.0;
    double hysteresis = 0.0; ///< how far it must have been on the other side of a bound before
};

/// A pulse from one edge to the opposite one; fires where it ends.
struct PulseTrigger {
    enum class Polarity : std::uint8_t { Positive, Negative } polarity = Polarity::Positive;
    double level = 0.0;
    double hysteresis = 0.0;
    DurationTest width;
};

/// How long the value takes from one level to the other; fires at the second one.
struct SlewTrigger {
    Slope slope = Slope::Rising;
    double low = 0.0;
    double high = 0.0;
    double hysteresis = 0.0; ///< at the level where it starts
    DurationTest time;
};

/// No edge for this long after one; fires when the time is over, and again only after another edge.
struct DropoutTrigger {
    EdgeTrigger edge;
    Nanos time = 0;
};

/// Every `count`th edge; with `idle` above 0 the `count`th after a pause of at least that long.
struct NthEdgeTrigger {
    EdgeTrigger edge;
    std::uint32_t count = 2;
    Nanos idle = 0;
};

/// Something that happened, told to Acquisition::event().
struct EventTrigger {
    enum class Kind : std::uint8_t {
        StateChange,
        Fault,
        RegisterWrite,
        SetPoint
    } kind = Kind::StateChange;
    std::optional<std::uint32_t> which; ///< only this state, fault bit, register or motor; else any
};

/// Where a value is between two samples.
enum class Between : std::uint8_t {
    Line, ///< on the straight line, so that edges have a time finer than a sample
    Hold ///< still that of the earlier one
};

struct TriggerCondition {
    std::variant<EdgeTrigger, LevelTrigger, WindowTrigger, PulseTrigger, SlewTrigger,
        DropoutTrigger, NthEdgeTrigger, EventTrigger>
        what;
    Between between = Between::Line;
    /// One turn of an angle, 0 for anything else: a step of more than half of it is the angle passing its end, not
    /// an edge. Leave it 0 to trigger on that step.
    double turn = 0.0;
};

enum class ConditionError : std::uint8_t {
    NotFinite, ///< a level or time that is no number
    NegativeHysteresis,
    LevelsSwapped, ///< low is not below high
    NoTime, ///< a dropout of no length, a range of durations without any
    NoCount
};

/// What is wrong with it; nullopt if it can be searched for.
std::optional<ConditionError> check(const TriggerCondition &condition);

/// How the channel's values lie between its samples: fast ones on a line, the others hold.
Between betweenSamples(const capture::ChannelInfo &info);

} // namespace scope
