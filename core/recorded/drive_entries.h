// What a drive tells and is told, as entries of a recording: samples and values as they are, everything that happens
// once in words. The words are English and part of the format, like those of a protocol; nothing here is shown as it
// is.
//
// What comes over and over without news, such as the state of a motor that stays the same, becomes no entry.
#pragma once

#include "drive/event.h"
#include "drive/wish.h"
#include "recorded/entry.h"

#include <array>
#include <map>
#include <set>
#include <vector>

namespace recorded {

class DriveEntries {
public:
    /// The entries of an event; most have one, many none.
    std::vector<Entry> accept(const drive::Event &event);
    /// A wish on its way to the drive. Reading is not told: what is read once, a hundred registers for a
    /// snapshot, is no signal and has no entry.
    std::vector<Entry> accept(const drive::Wish &wish);
    static Entry stop(); ///< every motor is to stop

    /// What holds now, for a recording that begins in the middle. Polled registers are described again.
    std::vector<Entry> state();
    /// Of that what values mean nothing without, for a recording that missed some entries.
    std::vector<Entry> descriptions();

private:
    std::vector<Entry> readings(const drive::RegistersRead &read);
    std::vector<Entry> status(const drive::MotorStatus &status);
    std::vector<Entry> counters(const drive::LinkCounters &counters);
    std::vector<Entry> ended(const drive::Ended &ended);
    Happening identity() const;
    std::string nameOf(RegisterId id) const;
    bool isSignal(RegisterId id) const;

    std::optional<drive::Identified> m_identified;
    std::optional<drive::LinkChanged> m_link;
    std::optional<capture::StreamLayout> m_layout;
    std::map<int, drive::MotorStatus> m_status;
    drive::LinkCounters m_counters;
    std::set<RegisterId> m_described;
    std::set<RegisterId> m_watched;
    std::map<drive::WishId, std::set<RegisterId>> m_readOnce; ///< by wishes that have not ended
    std::set<drive::WishId> m_waiting; ///< wishes whose end is worth an entry
};

/// The words of happenings, each list in the order of its enumeration: written here, read by the code that shows
/// a recording; they are part of the format (docs/recording-format.md) and are not translated.
inline constexpr std::array kActionWords{"start", "stop motor", "stop ramp", "acknowledge faults"};
inline constexpr std::array kLinkStateWords{
    "closed", "connecting", "connected", "suspect", "recovering", "lost"};
inline constexpr std::array kMotorStateWords{
    "unknown", "idle", "starting", "running", "stopping", "fault now", "fault over"};
inline constexpr std::array kOutcomeWords{"ok", "refused", "not sent", "unknown"};
inline constexpr std::array kStopWords{
    "requested", "accepted", "drive idle", "standstill", "NOT CONFIRMED", "speed not measurable"};

} // namespace recorded
