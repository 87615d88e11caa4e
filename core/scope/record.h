// A captured record: a stretch of the recording around a trigger. It holds times only; the samples stay in the
// capture. And the list of the last ones, with pins and labels.
#pragma once

#include "capture/tick_time.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scope {

using capture::Nanos;

using RecordId = std::uint32_t;

struct Record {
    RecordId id = 0;
    Nanos trigger = 0; ///< T = 0 of the record, on the session's axis
    Nanos from = 0;
    Nanos to = 0; ///< not included
    Nanos held = 0; ///< samples are there up to here; at least `to` once it is complete

    enum class Cause : std::uint8_t {
        Condition, ///< a sample fulfilled the condition
        Event, ///< something happened that was waited for
        Forced, ///< by the user
        Automatic ///< nothing came in time
    } cause = Cause::Condition;

    enum class State : std::uint8_t {
        Waiting, ///< for the samples after the trigger
        Complete,
        Cut, ///< stopped before all samples were there
        Released ///< kept for its pin and label; its samples are no longer in the capture
    } state = State::Waiting;

    bool pinned = false;
    std::string label; ///< of the user, UTF-8

    /// How long ago it was triggered.
    Nanos age(Nanos now) const { return now - trigger; }
};

/// The last records, oldest first. A pinned one stays until it is unpinned; one place is always left for a new one.
class RecordHistory {
public:
    static constexpr std::size_t kLabelBytes = 200;

    /// @param capacity  records kept, at least 1
    explicit RecordHistory(std::size_t capacity = 100);

    /// Replaces the record of the same id, or takes the place of the oldest that is not pinned.
    void add(Record record);

    const std::vector<Record> &records() const { return m_records; }
    const Record *find(RecordId id) const;

    /// False if the record is unknown or the last free place would be lost.
    bool setPinned(RecordId id, bool pinned);
    /// Cut to kLabelBytes, at the border of a character. False if the record is unknown.
    bool setLabel(RecordId id, std::string_view label);
    void clear(); ///< pinned ones too

    /// Samples before `oldest` are gone: drops the records that lie there, and marks the pinned ones.
    /// False if there is nothing new to that.
    bool release(Nanos oldest);

private:
    std::vector<Record>::iterator position(RecordId id);

    std::size_t m_capacity;
    std::vector<Record> m_records;
};

} // namespace scope
