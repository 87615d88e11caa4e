// The words of happenings in a recording, each list in the order of its enumeration. Written by drive_entries, found again
// by who shows a recording; they are part of the format (docs/recording-format.md) and are not translated.
#pragma once

#include <array>

namespace record {

inline constexpr std::array kActionWords{"start", "stop motor", "stop ramp", "acknowledge faults"};
inline constexpr std::array kLinkStateWords{
    "closed", "connecting", "connected", "suspect", "recovering", "lost"};
inline constexpr std::array kMotorStateWords{
    "unknown", "idle", "starting", "running", "stopping", "fault now", "fault over"};
inline constexpr std::array kOutcomeWords{"ok", "refused", "not sent", "unknown"};
inline constexpr std::array kStopWords{
    "requested", "accepted", "drive idle", "standstill", "NOT CONFIRMED", "speed not measurable"};

} // namespace record
