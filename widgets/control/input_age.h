// InputAge: how late the input is that is being handled. What the user typed into a window that stood still comes all
// at once when it thaws, and must not act then. Pure: times are arguments; it sees no events itself.
//
// Two rules, and input is as old as the worse of them says:
//  - The window itself. Where its heart has not beaten for longer than a wish may be old, everything that waited
//    meanwhile counts as that old, until two beats in a row were punctual again: by then the loop has handled what
//    waited. It needs nothing of the platform, and no input can be older than the gap it waited in. It may refuse an
//    input of the last moment, which is pressed once more.
//  - The time stamps of the events, where they are those of a clock, for input that is late before it reaches the
//    window (a display over the network). They are milliseconds since some time of the window system's. How far that
//    is from our clock is taken from events that agree for two seconds; an event that is farther away is late by the
//    difference. Stamps that keep no pace with our clock (tests, plug-ins that make them up) never agree, and count
//    for nothing; a clock that was set is found again by the same rule. A freeze cannot make late events agree:
//    they come at one time and carry different ones.
#pragma once

#include "base/time.h"

#include <cstdint>
#include <optional>

namespace widgets {

class InputAge {
public:
    void beat(TimePoint now); ///< of the window's heart, several times in half a second
    /// An input event is about to be handled. @param stamp  its own, in ms; 0: it has none
    void note(std::uint64_t stamp, TimePoint now);
    /// When the act was made that is handled now; what follows from it later counts as late as it was.
    TimePoint madeAt(TimePoint now) const { return now - m_delay; }

private:
    void lookForFreeze(TimePoint now);
    Duration lateness(std::uint64_t stamp, TimePoint now);

    static constexpr Duration kAgree = std::chrono::milliseconds(50);
    static constexpr Duration kAgreeFor = std::chrono::seconds(2);
    static constexpr int kAgreements = 8;
    static constexpr int kPunctualBeats = 2;

    std::optional<TimePoint> m_beat;
    Duration m_freeze{}; ///< zero: there was none of late
    int m_punctual = 0;
    Duration m_delay{}; ///< of the newest input

    std::optional<std::uint32_t> m_stamp; ///< the newest
    Duration m_stampTime{}; ///< unwrapped
    Duration m_distance{}; ///< from there to our clock, of the events that agree
    TimePoint m_agreeSince{};
    int m_agree = 0;
    std::optional<Duration> m_least; ///< that distance, once it is believed
};

} // namespace widgets
