// What a bench scope's Run, Single and Force do: turns hits of a trigger search, events and the lack of both into
// records. It has no clock: time is that of the samples, so that the same samples give the same records however they
// arrive. Records hold times; nothing is copied, and everything before the trigger is in the capture already.
//
//   run() ---> Armed --hit, event, force--> Triggered --all samples there--> Armed, or Stop after a single one
//              Armed --nothing for autoAfter, mode Auto--> Auto, until a hit comes
//              Roll: no records, the newest samples are shown
//
// Call order: run(), then advance() whenever the source has grown, and takeRecords() after it.
#pragma once

#include "scope/record.h"
#include "scope/trigger_search.h"

#include <utility>
#include <vector>

namespace scope {

enum class Mode : std::uint8_t { Auto, Normal, Single, Roll };

/// The word that stands on a scope's screen.
enum class AcquisitionState : std::uint8_t { Stop, Armed, Triggered, Auto, Roll };

struct AcquisitionSettings {
    TriggerCondition condition;
    Mode mode = Mode::Auto;
    Nanos length = 100'000'000; ///< of a record
    double preTrigger = 0.5; ///< share of the record that is before the trigger, 0 to 1
    Nanos holdOff = 0; ///< from one trigger to the next at least; never before the record is over
    Nanos autoAfter = 200'000'000; ///< how long mode Auto waits
};

/// Something that happened, for an EventTrigger.
struct Happening {
    Nanos time = 0; ///< on the session's axis
    EventTrigger::Kind kind = EventTrigger::Kind::StateChange;
    std::uint32_t which = 0; ///< the new state, the new fault bits, or the register's id
};

class Acquisition {
public:
    explicit Acquisition(const AcquisitionSettings &settings = {});

    /// Takes effect at once: a record that waits is cut, and if it was running it arms anew.
    /// @param source  the channel that is watched, nullptr if there is none yet
    void configure(const AcquisitionSettings &settings, const capture::Channel *source);
    const AcquisitionSettings &settings() const { return m_settings; }

    /// Arms: only samples and events from now on count.
    void run(const capture::Channel *source);
    /// A record that waits for samples is cut. Nothing happens until run().
    void stop();
    /// A trigger at `now`, which is cut to where the samples end. Only while armed or automatic, and not before
    /// advance() or run() saw a sample: a record would begin nowhere.
    void force(Nanos now);
    void event(const Happening &happening);

    /// The source holds more samples than before. Another channel than the last time is searched from its first
    /// sample on.
    void advance(const capture::Channel &source);

    AcquisitionState state() const;
    /// The record that waits for its samples; nullptr if none does.
    const Record *current() const { return m_current ? &*m_current : nullptr; }
    /// Records that are over (complete or cut) since the last call, oldest first; at most the last kMostUntaken.
    std::vector<Record> takeRecords() { return std::exchange(m_over, {}); }

    static constexpr std::size_t kMostUntaken = 1000;

private:
    /// A trigger that may start a record.
    struct Candidate {
        Nanos time;
        Nanos decided; ///< when the sample came that decided it
        Record::Cause cause;
    };

    bool isAutomatic() const { return m_current && m_current->cause == Record::Cause::Automatic; }
    void look(const capture::Channel &source);
    void begin(Nanos time, Record::Cause cause);
    void finish(Record::State state);
    bool step(Nanos held);

    AcquisitionSettings m_settings;
    bool m_running = false;
    bool m_automatic = false; ///< the last record was, and no hit came since
    std::optional<TriggerSearch> m_search;
    std::optional<capture::ChannelId> m_source;
    static constexpr Nanos kNoTime = std::numeric_limits<Nanos>::min();
    Nanos m_notBefore = kNoTime;
    std::optional<Nanos> m_waitingSince; ///< from when mode Auto counts
    Nanos m_held = kNoTime; ///< of samples seen since run(), and of those that were there then
    std::optional<Candidate> m_candidate;
    std::optional<Record> m_current;
    std::vector<Record> m_over;
    RecordId m_nextId = 1;
};

/// Up to where everything about a channel is known; not on an empty one.
Nanos heldUntil(const capture::Channel &channel);

} // namespace scope
