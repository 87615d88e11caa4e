// A pair of cursors: where they are, what each channel is worth there and between them. Values are those of the sample
// before (previous-sample hold), so that nothing is shown before it was recorded. Several named pairs are several of
// these; markers are a time and a note.
#pragma once

#include "capture/channel.h"

#include <optional>
#include <string>

namespace scope {

using capture::Nanos;

struct CursorPair {
    std::string name; ///< of a person, UTF-8
    Nanos a = 0; ///< on the session's axis
    Nanos b = 0;

    double seconds() const { return capture::toSeconds(b - a); } ///< negative if b is before a
    /// 1 / |seconds|; nullopt if both are at the same place.
    std::optional<double> hertz() const
    {
        return a == b ? std::nullopt : std::optional(1.0 / std::abs(seconds()));
    }
};

struct Marker {
    Nanos time = 0;
    std::string note; ///< of a person, UTF-8
};

/// One channel under a pair of cursors, in the channel's unit; nothing in gaps.
struct CursorValues {
    std::optional<double> a;
    std::optional<double> b;
    std::optional<double> delta; ///< b - a
    std::optional<double> slope; ///< delta a second; nothing if both are at the same place
};

CursorValues valuesAt(const capture::Channel &channel, const CursorPair &cursors);

/// `steps` samples of the channel later (earlier if negative): the nearest sample in that direction first. Stays at the
/// first and the last sample; where it is if the channel is empty.
Nanos nudged(const capture::Channel &channel, Nanos cursor, std::int64_t steps);

/// The sample nearest to `cursor`; where it is if the channel is empty.
Nanos snapped(const capture::Channel &channel, Nanos cursor);

} // namespace scope
